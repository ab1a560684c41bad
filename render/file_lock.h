#pragma once

#include <optional>
#include <string>

namespace fairlight {

/// An open file that can be locked: against other processes, and against other FileLocks of this one. The system takes a
/// lock away with the process that has it, however that ends, so that none is left behind.
class FileLock {
 public:
  /// Opens the file with the flags of open(2). Throws std::runtime_error, saying what could not be done: "write", "read".
  FileLock(const std::string& path, int flags, const char* to_do);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

  /// Locks as flock(2) does. False where another has a lock, with LOCK_NB; else it waits for that to end.
  bool lock(int kind);

  int descriptor() const { return file_; }

  /// Throws std::runtime_error with the system's reason.
  [[noreturn]] void fail(const char* doing) const;

 private:
  std::string path_;
  int file_;
};

/// Says that this run alone writes a file, from before it reads what the file replaces until that is replaced. What is
/// locked is an empty file beside it, F.lock, and not the file itself, as that becomes another one when it is replaced.
class OutputLock {
 public:
  /// Follows a symbolic link as AtomicFile does. Throws std::runtime_error when another run has the lock, or the folder
  /// cannot be written.
  explicit OutputLock(const std::string& path);
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  /// Removes F.lock.
  ~OutputLock();

 private:
  bool take(const std::string& path);

  std::string lock_path_;
  std::optional<FileLock> lock_;
};

}  // namespace fairlight
