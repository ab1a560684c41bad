#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fairlight/render/atomic_file.h>
#include <fairlight/render/file_lock.h>

namespace fairlight {

FileLock::FileLock(const std::string& path, int flags, const char* to_do)
    : path_(path), file_(open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666)) {
  if (file_ < 0) fail(to_do);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

bool FileLock::lock(int kind) {
  while (flock(file_, kind) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) fail("lock");
  }
  return true;
}

void FileLock::fail(const char* doing) const {
  throw std::runtime_error(std::string("cannot ") + doing + " \"" + path_ + "\" (" + std::strerror(errno) + ")");
}

OutputLock::OutputLock(const std::string& path) : lock_path_(resolved_output(path) + ".lock") {
  while (!take(path)) {
  }
}

// Returns false if the lock must be taken again: the previous owner removes its lock file, perhaps
// after it is opened here and before it is locked, and a lock on a removed file excludes nobody.
bool OutputLock::take(const std::string& path) {
  FileLock file(lock_path_, O_RDWR | O_CREAT | O_NOFOLLOW, "write");
  if (!file.lock(LOCK_EX | LOCK_NB))
    throw std::runtime_error("\"" + path + "\" is being written by another run (wait for it, or give another -o)");
  struct stat locked {
  }, there{};
  if (fstat(file.descriptor(), &locked) != 0) file.fail("lock");
  if (!S_ISREG(locked.st_mode) || locked.st_size != 0)
    throw std::runtime_error("\"" + lock_path_ + "\" is in the way (move it: it is to be the lock of \"" + path +
                             "\")");
  if (stat(lock_path_.c_str(), &there) != 0 || there.st_dev != locked.st_dev || there.st_ino != locked.st_ino)
    return false;
  lock_.emplace(std::move(file));
  return true;
}

OutputLock::~OutputLock() { unlink(lock_path_.c_str()); }  // still locked

}  // namespace fairlight
