#include <cstdlib>
#include <exception>
#include <string_view>

#include <fuzz/readers.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fairlight/render/picture.h>
#include <fairlight/validation/run/ledger.h>
#include <fairlight/validation/run/replay_token.h>

namespace fairlight::fuzz {
namespace {

/// A file in memory.
class MemoryFile {
 public:
  explicit MemoryFile(Bytes bytes) : descriptor_(memfd_create("fuzz", 0)) {
    if (descriptor_ < 0 || write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      std::abort();
  }
  MemoryFile(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

// Takes or refuses; a refusal is one sentence on one line.
void taken_or_refused(const auto& read) {
  try {
    read();
  } catch (const std::exception& refusal) {
    const std::string_view text = refusal.what();
    if (text.empty() || text.size() > 1000 || text.find('\n') != text.npos) std::abort();
  }
}

}  // namespace

void read_picture(Bytes bytes) {
  const MemoryFile file(bytes);
  taken_or_refused([&] { read_exr(file.path()); });
}

void read_ledger(Bytes bytes) {
  const MemoryFile file(bytes);
  taken_or_refused([&] { Ledger::read(file.path()).text(); });
}

void read_token(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  taken_or_refused([&] { parse_replay_token(text); });
}

}  // namespace fairlight::fuzz
