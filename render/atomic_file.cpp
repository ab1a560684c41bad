#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <fairlight/render/atomic_file.h>

namespace fairlight {

std::string resolved_output(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : fs::path(path);
  const std::string folder = fs::weakly_canonical(fs::absolute(path).parent_path(), error).string();
  const bool device = folder == "/dev" || folder.starts_with("/dev/") || folder.starts_with("/proc");
  if (path.empty() || device || (fs::exists(target, error) && !fs::is_regular_file(target, error))) {
    throw std::runtime_error("cannot write \"" + path + "\" (give the name of a file; what is there is none)");
  }
  return target.string();
}

AtomicFile::AtomicFile(const std::string& path)
    : path_(resolved_output(path)), partial_(path_ + ".part" + std::to_string(getpid())) {
  file_ = std::fopen(partial_.c_str(), "wbx");
  if (file_ == nullptr) fail("write");
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(partial_.c_str());
}

void AtomicFile::write(std::span<const char> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("write");
}

std::uint64_t AtomicFile::position() const { return static_cast<std::uint64_t>(std::ftell(file_)); }

void AtomicFile::seek(std::uint64_t position) {
  if (std::fseek(file_, static_cast<long>(position), SEEK_SET) != 0) fail("write");
}

void AtomicFile::commit() {
  if (failed_) throw std::runtime_error("cannot write \"" + path_ + "\" (an earlier write failed)");
  if (std::fflush(file_) != 0 || fsync(fileno(file_)) != 0) fail("write");
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail("put in place");
  std::fclose(file_);
  file_ = nullptr;
}

void AtomicFile::check_writable(const std::string& path) { const AtomicFile probe(path); }

void AtomicFile::fail(const char* doing) {
  failed_ = true;
  throw std::runtime_error(std::string("cannot ") + doing + " \"" + path_ + "\" (" + std::strerror(errno) + ")");
}

std::string read_whole(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw std::runtime_error("cannot read \"" + path + "\" (" + std::strerror(errno) + ")");
  return bytes;
}

void write_whole(const std::string& path, std::span<const char> bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

void write_json(const std::string& path, const nlohmann::json& json) { write_whole(path, json.dump(2) + "\n"); }

}  // namespace fairlight
