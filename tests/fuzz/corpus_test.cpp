#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fuzz/readers.h>
#include <gtest/gtest.h>

namespace fairlight::fuzz {
namespace {

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Inputs that were once a problem, and some of every kind, tests/fuzz/corpus/READER/*: each is taken or
// refused in one sentence.
TEST(Fuzz, TheCorpusIsTakenOrRefused) {
  for (const Reader& reader : readers) {
    const std::filesystem::path folder =
        std::filesystem::path(FAIRLIGHT_SOURCE_DIR) / "tests/fuzz/corpus" / reader.name;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      SCOPED_TRACE(entry.path());
      reader.read(bytes_of(entry.path()));
      ++files;
    }
    EXPECT_GT(files, 0u) << folder;
  }
}

// Every beginning of every file of the corpus, and every file with one byte changed.
TEST(Fuzz, DamagedFilesAreTakenOrRefused) {
  for (const Reader& reader : readers) {
    const std::filesystem::path folder =
        std::filesystem::path(FAIRLIGHT_SOURCE_DIR) / "tests/fuzz/corpus" / reader.name;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::vector<std::uint8_t> bytes = bytes_of(entry.path());
      const std::size_t step = 1 + bytes.size() / 64;
      for (std::size_t i = 0; i < bytes.size(); i += step) {
        reader.read({bytes.data(), i});
        bytes[i] ^= 0x55;
        reader.read(bytes);
        bytes[i] ^= 0x55;
      }
    }
  }
}

}  // namespace
}  // namespace fairlight::fuzz
