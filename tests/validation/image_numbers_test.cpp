#include <gtest/gtest.h>

#include <fairlight/validation/claims/image_numbers.h>

namespace fairlight {
namespace {

const StreamKey key(1, "test");

TEST(ImagePlace, IsAfterTheUnitsOfTheImagesBefore) {
  EXPECT_EQ(ImagePlace(key, 0, 8).first, 0u);
  EXPECT_EQ(ImagePlace(key, 5, 8).first, 40u);
  EXPECT_EQ(ImagePlace(key, 5, 8).key.words(), key.words());
}

// 2^32 is 1431655765 times 3 and 1 more: the last unit stays free, so that no image is of two keys.
TEST(ImagePlace, HasTheNextKeyWhereAnImageWouldNotFitIntoThisOne) {
  const std::uint64_t images = 1431655765;
  const ImagePlace last(key, images - 1, 3), next(key, images, 3), after(key, 2 * images + 1, 3);
  EXPECT_EQ(last.first, 4294967292u);
  EXPECT_EQ(last.key.words(), key.words());
  EXPECT_EQ(next.first, 0u);
  EXPECT_EQ(next.key.words(), key.further(1).words());
  EXPECT_EQ(after.first, 3u);
  EXPECT_EQ(after.key.words(), key.further(2).words());
}

TEST(ImagePlace, FillsAKeyWhereImagesDivideIt) {
  const std::uint64_t images = std::uint64_t{1} << 22;
  EXPECT_EQ(ImagePlace(key, images - 1, 1024).first, 4294966272u);
  EXPECT_EQ(ImagePlace(key, images, 1024).first, 0u);
  EXPECT_EQ(ImagePlace(key, images, 1024).key.words(), key.further(1).words());
}

}  // namespace
}  // namespace fairlight
