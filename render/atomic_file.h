#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace fairlight {

/// A file that appears whole or not at all. It is written under another name in the same folder,
/// and commit() renames it. Errors throw std::runtime_error with the file's name and the system's
/// reason.
class AtomicFile {
 public:
  /// Follows a symbolic link: its target is replaced, not the link. Throws when the folder does not
  /// exist or cannot be written, or when the path is not a regular file, such as a folder or a
  /// device.
  explicit AtomicFile(const std::string& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Removes the file, unless it was committed.
  ~AtomicFile();

  void write(std::span<const char> bytes);
  std::uint64_t position() const;
  void seek(std::uint64_t position);

  /// Flushes the file to the disk and renames it into place. Also throws for an error of an earlier
  /// write.
  void commit();

  /// Throws as the constructor would, and leaves nothing behind. Lets a long run fail before it
  /// starts.
  static void check_writable(const std::string& path);

 private:
  [[noreturn]] void fail(const char* doing);

  std::string path_;
  std::string partial_;
  std::FILE* file_ = nullptr;
  bool failed_ = false;
};

/// The path of an output, with symbolic links followed. Throws std::runtime_error when the path
/// exists and is not a regular file, such as a folder or a device.
std::string resolved_output(const std::string& path);

/// Reads all bytes of a file. Throws std::runtime_error if it cannot be read.
std::string read_whole(const std::string& path);

/// Writes bytes through an AtomicFile.
void write_whole(const std::string& path, std::span<const char> bytes);

/// Writes JSON through an AtomicFile.
void write_json(const std::string& path, const nlohmann::json& json);

}  // namespace fairlight
