#include <gtest/gtest.h>

#include <fairlight/estimators/table.h>

namespace fairlight {
namespace {

// Sizes that fit into registers, and larger ones.
TEST(Table, GivesEachLaneTheNumberOfItsIndex) {
  for (const std::size_t size : {1, 7, 8, 9, 16, 17, 32, 33, 1000}) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < size; ++i) squares.push_back(static_cast<double>(i * i));
    const Table<double> in_double(squares);
    const Table<Packet> in_packets(squares);
    std::array<int, lanes<Packet>> indices{};
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<int>((11 * i + size - 1) % size);
    const auto index = Index<Packet>::load_unaligned(indices.data());
    std::array<double, lanes<Packet>> found{};
    store_lanes(in_packets(index), found.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      EXPECT_EQ(found[i], indices[i] * indices[i]) << "of " << size;
      EXPECT_EQ(in_double(indices[i]), indices[i] * indices[i]);
    }
  }
}

}  // namespace
}  // namespace fairlight
