#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fairlight/render/file_lock.h>
#include <fairlight/validation/run/ledger.h>
#include <fairlight/validation/run/ledger_text.h>

namespace fairlight {
namespace {

// What a writer appends to an incomplete last line, which a killed writer has left.
constexpr std::string_view torn_end = " torn\n";

// A file that is open and locked until the end of the scope.
class LockedFile {
 public:
  LockedFile(const std::string& path, int flags, int kind, const char* to_do) : lock_(path, flags, to_do) {
    lock_.lock(kind);
    struct stat status {};
    if (fstat(file_, &status) != 0) lock_.fail(to_do);
    if (!S_ISREG(status.st_mode)) throw std::runtime_error("\"" + path + "\" is not a ledger (it is not a file)");
    size_ = status.st_size;
  }

  off_t size() const { return size_; }

  std::string read(off_t from, off_t length) const {
    std::string bytes(static_cast<std::size_t>(length), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t n = pread(file_, bytes.data() + done, bytes.size() - done, from + static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) lock_.fail("read");
      if (n == 0) break;
      done += static_cast<std::size_t>(n);
    }
    bytes.resize(done);
    return bytes;
  }

  // Appends all of the bytes or none, in one call if the system takes them.
  void append(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = write(file_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) take_back();
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    if (fsync(file_) != 0) lock_.fail("write");
  }

 private:
  [[noreturn]] void take_back() {
    const int error = errno;
    [[maybe_unused]] const int ignored = ftruncate(file_, size_);
    errno = error;
    lock_.fail("write");
  }

  FileLock lock_;
  int file_ = lock_.descriptor();
  off_t size_ = 0;
};

// Throws unless the file is empty or begins as a ledger does.
void check_header(const std::string& path, std::string_view beginning) {
  const std::string_view stem = ledger_header.substr(0, ledger_header.find_last_of(' ') + 1);
  const std::string_view head = beginning.substr(0, ledger_header.size());
  if (beginning.empty() || head == ledger_header) return;
  const std::string named = "\"" + path + "\" is ";
  if (ledger_header.starts_with(head))
    throw std::runtime_error(named + "cut inside its first line (it holds no run; remove it)");
  if (head.starts_with(stem))
    throw std::runtime_error(named + "a ledger of another version (this program knows version 1)");
  throw std::runtime_error(named + "not a ledger (its first line is another)");
}

}  // namespace

void Ledger::add_file(const std::string& path) {
  const LockedFile file(path, O_RDONLY, LOCK_SH, "read");
  const std::string bytes = file.read(0, file.size());
  check_header(path, bytes);
  torn_ = false;
  std::string_view rest = std::string_view(bytes).substr(std::min(bytes.size(), ledger_header.size()));
  for (int number = 2; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
      torn_ = true;
      break;
    }
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    if (line.ends_with(torn_end.substr(0, torn_end.size() - 1))) continue;
    const auto entry = entry_of(line);
    if (!entry) {
      throw std::runtime_error("line " + std::to_string(number) + " of \"" + path +
                               "\" is damaged (remove it to go on without it)");
    }
    add(*entry);
  }
}

Ledger Ledger::read(const std::string& path) {
  Ledger ledger;
  ledger.add_file(path);
  return ledger;
}

Ledger Ledger::read_if_there(const std::string& path) {
  return access(path.c_str(), F_OK) != 0 && errno == ENOENT ? Ledger() : read(path);
}

void Ledger::add(const LedgerEntry& later) {
  const auto [place, is_new] = entries_.try_emplace({later.claim, later.content}, later);
  if (is_new) return;
  LedgerEntry& here = place->second;
  if (std::ranges::none_of(later.seeds, [&](std::uint64_t seed) { return here.seeds.contains(seed); })) {
    here.evidence_sum.append(later.evidence_sum);
    here.seeds.insert(later.seeds.begin(), later.seeds.end());
    here.draws += later.draws;
    return;
  }
  ++repeated_;
  if (later.seeds.size() > here.seeds.size()) here = later;
}

void Ledger::append(const std::string& path, const std::vector<LedgerEntry>& entries) {
  LockedFile file(path, O_RDWR | O_APPEND | O_CREAT, LOCK_EX, "write");
  check_header(path, file.read(0, static_cast<off_t>(ledger_header.size())));
  std::string bytes(file.size() == 0 ? ledger_header : "");
  if (file.size() > 0 && file.read(file.size() - 1, 1) != "\n") bytes += torn_end;
  for (const LedgerEntry& entry : entries) bytes += line_of(entry);
  file.append(bytes);
}

std::string Ledger::text() const {
  std::string text(ledger_header);
  for (const auto& [key, entry] : entries_) text += line_of(entry);
  return text;
}

const LedgerEntry* Ledger::find(const Key& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : &found->second;
}

}  // namespace fairlight
