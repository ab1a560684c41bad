#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace fairlight {

/// A file that appears whole or not at all: written beside its place under another name, and put there by commit().
/// Errors throw std::runtime_error, saying which file and what the system said.
class AtomicFile {
 public:
  /// A symbolic link is followed: what it points to is replaced, not the link. Throws when the folder does not exist or
  /// cannot be written, or when something that is not a file is in the way, such as a folder or a device.
  explicit AtomicFile(const std::string& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Removes what was written, unless it was committed.
  ~AtomicFile();

  void write(std::span<const char> bytes);
  std::uint64_t position() const;
  void seek(std::uint64_t position);

  /// Writes through to the disk and puts the file in its place; throws also for an error in an earlier write.
  void commit();

  /// Throws as the constructor would, so that a long run can fail before it starts. Leaves nothing behind.
  static void check_writable(const std::string& path);

 private:
  [[noreturn]] void fail(const char* doing);

  std::string path_;
  std::string partial_;
  std::FILE* file_ = nullptr;
  bool failed_ = false;
};

/// Where an output is to be, past a symbolic link. Throws std::runtime_error where something is in the way that is no
/// file, such as a folder or a device.
std::string resolved_output(const std::string& path);

/// All bytes of a file. Throws std::runtime_error where it cannot be read.
std::string read_whole(const std::string& path);

/// Writes bytes as a AtomicFile.
void write_whole(const std::string& path, std::span<const char> bytes);

/// Writes JSON as a AtomicFile.
void write_json(const std::string& path, const nlohmann::json& json);

}  // namespace fairlight
