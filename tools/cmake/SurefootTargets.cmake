# One function for a room, one for its tests: the same warnings and sanitizers everywhere.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# -O2 and no contraction: the same source gives the same bits wherever the mathematical library does
# (glibc picks its sine by the processor: with and without FMA the last bits differ).
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_C_FLAGS_RELEASE "-O2")
# For the sanitizers: fast enough to walk, quick to build, with Eigen's own assertions.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")
set(CMAKE_C_FLAGS_RELWITHDEBINFO "-O1 -g1")
find_program(CCACHE ccache)
if(CCACHE)
  # Without this, ccache keeps nothing that was compiled with a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
endif()

function(surefoot_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR})
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion
                                           $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> -Werror)
  if(SUREFOOT_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${SUREFOOT_SANITIZE} -fno-omit-frame-pointer
                                            -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${SUREFOOT_SANITIZE})
  endif()
endfunction()

# surefoot_room(NAME [EXCLUDE REGEX...]): a static library of all sources below the current folder.
function(surefoot_room target)
  cmake_parse_arguments(ARG "" "" "EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.c)
  foreach(regex "/main\\.cpp$" ${ARG_EXCLUDE})
    list(FILTER sources EXCLUDE REGEX ${regex})
  endforeach()
  add_library(${target} STATIC ${sources})
  surefoot_options(${target})
endfunction()

# What every test includes, compiled once for all tests of an optimisation (120 MB). With the sanitizers tests take longer
# to compile than to run, but for properties with their thousands of cases.
function(surefoot_quick_to_compile target labels)
  set(optimisation)
  if(SUREFOOT_SANITIZE AND NOT "property" IN_LIST labels)
    set(optimisation -O0)
  endif()
  set(shared test_headers${optimisation})
  if(NOT TARGET ${shared})
    file(WRITE ${CMAKE_BINARY_DIR}/test_headers.cpp "")
    add_library(${shared} OBJECT ${CMAKE_BINARY_DIR}/test_headers.cpp)
    surefoot_options(${shared})
    target_link_libraries(${shared} PRIVATE GTest::gtest GTest::gmock)
    target_compile_options(${shared} PRIVATE ${optimisation})
    target_precompile_headers(${shared} PRIVATE <gtest/gtest.h> <gmock/gmock.h>)
  endif()
  target_compile_options(${target} PRIVATE ${optimisation})
  target_precompile_headers(${target} REUSE_FROM ${shared})
endfunction()

# surefoot_test(NAME LABELS ... LIBRARIES ... [SANITIZED REGEX]): one GoogleTest program of all *_test.cpp of the current
# folder; with sanitizers of those files alone that match.
function(surefoot_test target)
  cmake_parse_arguments(ARG "" "TIMEOUT;SANITIZED" "LABELS;LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  if(SUREFOOT_SANITIZE AND ARG_SANITIZED)
    list(FILTER sources INCLUDE REGEX "${ARG_SANITIZED}")
  endif()
  if(NOT sources)
    return()
  endif()
  add_executable(${target} ${sources})
  surefoot_options(${target})
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  surefoot_quick_to_compile(${target} "${ARG_LABELS}")
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  # LCM stays on this machine's loopback, or nowhere.
  gtest_discover_tests(${target} DISCOVERY_TIMEOUT 60
                       PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
