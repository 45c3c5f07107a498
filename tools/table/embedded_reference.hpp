#pragma once

namespace surefoot::table {

/// Text of the files in tools/table/reference/.
extern const char* const kTableOff;
extern const char* const kTableOriginal;
extern const char* const kTableModified;

}  // namespace surefoot::table
