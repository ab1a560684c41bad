#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/built_objects.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view claims_folder = "validation/claims/";

std::string folder_of(const std::string& file) { return file.substr(0, file.find('/') + 1); }

bool is_library(const BuiltObject& object) {
  static const std::regex below(R"(^(?:stats|estimators|render|validation/(?:checks|run|report))/)");
  return std::regex_search(object.source, below);
}

bool is_claims(const BuiltObject& object) { return object.source.starts_with(claims_folder); }

// A header for itself. For a .cpp its own header, or else what it includes from its folder.
std::set<std::string> headers_of(const std::string& file, const std::set<std::string>& files) {
  if (!file.ends_with(".cpp")) return {file};
  const std::string header = file.substr(0, file.size() - 3) + "h";
  if (files.contains(header)) return {header};
  std::set<std::string> near;
  for (const std::string& other : files) {
    if (other != file && folder_of(other) == folder_of(file)) near.insert(other);
  }
  return near;
}

}  // namespace

BuiltObjects::BuiltObjects(const BuildPlaces& places) : places_(places) {
  read_commands();
  read_dependencies();
  std::vector<std::string> program;
  for (const auto& [path, object] : objects_) {
    if (is_library(object) || is_claims(object)) program.push_back(path);
  }
  read_symbols(program);
}

void BuiltObjects::read_commands() {
  static const std::regex output(" -o (\\S+)");
  for (const auto& entry : nlohmann::json::parse(read_whole(places_.build + "/compile_commands.json"))) {
    const std::string source = within_source(entry["file"]), command = entry["command"];
    std::smatch match;
    if (source.empty() || command.find("FAIRLIGHT_ENTRY") != std::string::npos) continue;
    if (!std::regex_search(command, match, output)) continue;
    objects_[match[1]] = {match[1], source, std::regex_replace(command, output, ""), {source}};
  }
}

// Parses the output of `ninja -t deps`: the name of an object with a colon, then its files, indented.
void BuiltObjects::read_dependencies() {
  const ProcessResult listing = run_process({"ninja", "-C", places_.build, "-t", "deps"});
  if (listing.status != 0)
    throw std::runtime_error("ninja does not list the dependencies of \"" + places_.build +
                             "\" (build it with ninja)");
  std::istringstream lines(listing.out);
  BuiltObject* object = nullptr;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("    ")) {
      const auto found = objects_.find(line.substr(0, line.find(':')));
      object = found == objects_.end() ? nullptr : &found->second;
    } else if (object != nullptr) {
      const std::string file = within_source(line.substr(4));
      if (!file.empty()) object->files.insert(file);
    }
  }
}

// A path of the build, relative to the source folder; empty for a file elsewhere. The build finds
// headers through links in its own folder.
std::string BuiltObjects::within_source(const std::string& path) const {
  const std::string links = places_.build + "/include/fairlight/";
  if (path.starts_with(links)) return path.substr(links.size());
  if (!path.starts_with(places_.source + "/") || path.starts_with(places_.build + "/")) return "";
  return path.substr(places_.source.size() + 1);
}

// Parses the output of nm for many objects: the name of each with a colon, then a line for each
// symbol: its name, its type and more.
void BuiltObjects::read_symbols(const std::vector<std::string>& paths) {
  std::vector<std::string> command{"nm", "-g", "-P"};
  for (const std::string& path : paths) command.push_back(places_.build + "/" + path);
  // With one object alone nm does not print its name.
  if (paths.size() == 1) command.push_back(command.back());
  std::istringstream lines(run_process(command).out);
  std::string path;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(":")) {
      path = line.substr(0, line.size() - 1).substr(std::min(line.size() - 1, places_.build.size() + 1));
      calls_[path];
      continue;
    }
    std::istringstream words(line);
    std::string symbol, type;
    if (!(words >> symbol >> type)) continue;
    if (type == "U") {
      calls_[path].push_back(symbol);
    } else if (is_library(objects_.at(path))) {
      defining_[symbol].push_back(path);
    }
  }
}

const std::set<std::string>& BuiltObjects::called_by(const std::string& path) {
  const auto [known, is_new] = called_.try_emplace(path);
  if (!is_new) return known->second;
  if (!calls_.contains(path)) read_symbols({path});
  std::vector<std::string> open{path};
  while (!open.empty()) {
    const std::string caller = open.back();
    open.pop_back();
    for (const std::string& symbol : calls_[caller]) {
      const auto found = defining_.find(symbol);
      if (found == defining_.end()) continue;
      for (const std::string& callee : found->second) {
        if (known->second.insert(callee).second) open.push_back(callee);
      }
    }
  }
  return known->second;
}

std::vector<std::string> BuiltObjects::with(const std::string& file) const {
  std::vector<std::string> paths;
  for (const auto& [path, object] : objects_) {
    if ((is_claims(object) || is_library(object)) && object.files.contains(file)) paths.push_back(path);
  }
  return paths;
}

std::vector<std::string> BuiltObjects::tests_with(const std::string& file) const {
  std::set<std::string> headers{file};
  for (const auto& [path, object] : objects_) {
    if (object.source == file) headers = headers_of(file, object.files);
  }
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const auto& [path, object] : objects_) {
    const bool near = object.source.starts_with("tests/" + folder_of(file)) && object.source.ends_with("_test.cpp");
    const bool needs =
        std::ranges::any_of(headers, [&](const std::string& header) { return object.files.contains(header); });
    if (near && needs) found.emplace_back(object.files.size(), path);
  }
  std::ranges::sort(found);
  std::vector<std::string> paths;
  for (auto& [size, path] : found) paths.push_back(std::move(path));
  return paths;
}

std::string BuiltObjects::of_source(const std::string& source) const {
  for (const auto& [path, object] : objects_) {
    if (object.source == source) return path;
  }
  throw std::runtime_error("the build does not know \"" + source + "\" (build the program again)");
}

std::string BuiltObjects::link_command(const std::string& program) const {
  const std::string all = run_process({"ninja", "-C", places_.build, "-t", "commands", program}).out;
  const std::size_t end = all.find_last_not_of('\n') + 1;
  const std::size_t begin = all.rfind('\n', end - 1) + 1;
  const std::string last = all.substr(begin, end - begin);
  if (last.find(formatted(" -o %s ", program.c_str())) == std::string::npos)
    throw std::runtime_error("it is not known how \"" + places_.build + "\" links " + program +
                             " (build it with ninja)");
  return last;
}

std::string BuiltObjects::with_options(const std::string& command, const std::string& options) {
  static const std::regex compiler(R"(^((?:: && )?\S+))");
  return std::regex_replace(command, compiler, "$1 " + options, std::regex_constants::format_first_only);
}

}  // namespace fairlight
