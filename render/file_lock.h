#pragma once

#include <optional>
#include <string>

namespace fairlight {

/// An open file that can be locked against other processes and against other FileLocks of this one.
/// The system releases the lock when the process ends, however it ends.
class FileLock {
 public:
  /// Opens the file with the flags of open(2). Throws std::runtime_error with `to_do`, the action
  /// that failed: "write" or "read".
  FileLock(const std::string& path, int flags, const char* to_do);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

  /// Locks as flock(2) does. Waits while another has the lock; with LOCK_NB, returns false instead.
  bool lock(int kind);

  int descriptor() const { return file_; }

  /// Throws std::runtime_error with the system's reason.
  [[noreturn]] void fail(const char* doing) const;

 private:
  std::string path_;
  int file_;
};

/// Makes this run the only writer of a file F, from before it reads the old F until it has replaced
/// it. Locks an empty file F.lock beside F, as F itself becomes another file when it is replaced.
class OutputLock {
 public:
  /// Follows a symbolic link as AtomicFile does. Throws std::runtime_error when another run has the
  /// lock or the folder cannot be written.
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
