#include "weavefront/io/sha256.hpp"

#include <gtest/gtest.h>

#include "scratch_directory.hpp"

namespace weavefront::io {
namespace {

// FIPS 180-2, appendix B.1.
const std::string of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Sha256, IsThatOfTheStandard) { EXPECT_EQ(sha256_of("abc"), of_abc); }

TEST(Sha256, OfPartsIsThatOfTheWholeAtAnyMoment) {
    Sha256 sha256;
    sha256.add("a");
    EXPECT_EQ(sha256.hex(), sha256_of("a"));
    sha256.add("bc");
    EXPECT_EQ(sha256.hex(), of_abc);
}

TEST(Sha256, OfAFileIsThatOfItsText) {
    const parallel::Communicator comm(MPI_COMM_SELF);
    const ScratchDirectory directory(comm);
    const std::string text(3'000'000, 'x');  // more than is read at once
    std::ofstream(directory / "file") << text;
    EXPECT_EQ(sha256_of_file(directory / "file"), sha256_of(text));
    EXPECT_EQ(sha256_of_file(directory / "missing"), "");
}

}  // namespace
}  // namespace weavefront::io
