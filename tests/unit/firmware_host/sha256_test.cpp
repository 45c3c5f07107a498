#include "firmware/host/sha256.hpp"

#include <gtest/gtest.h>

namespace surefoot::host {
namespace {

// FIPS 180-4 examples (NIST): the empty message and "abc".
TEST(Sha256, GivesThePublishedDigests) {
  EXPECT_EQ(Sha256().hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  Sha256 digest;
  digest.update("a", 1);
  digest.update("bc", 2);
  EXPECT_EQ(digest.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, GoesOnAfterADigestWasTaken) {
  Sha256 interrupted;
  interrupted.update("a", 1);
  static_cast<void>(interrupted.hex());
  interrupted.update("bc", 2);
  Sha256 whole;
  whole.update("abc", 3);
  EXPECT_EQ(interrupted.hex(), whole.hex());
}

}  // namespace
}  // namespace surefoot::host
