#include "percal/text/sha256.hpp"

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace percal {
namespace {

// The two examples of FIPS 180-4, and the empty text.
TEST(Sha256, GivesTheDigestsOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, IsOfAFilesBytesAndOfNothingElse) {
  const test::ProgramFolder folder;
  EXPECT_EQ(sha256_of_file(folder.write("abc", "abc")), sha256("abc"));
  EXPECT_FALSE(sha256_of_file(folder.path("nowhere")));
  EXPECT_FALSE(sha256_of_file("/dev/null"));
}

}  // namespace
}  // namespace percal
