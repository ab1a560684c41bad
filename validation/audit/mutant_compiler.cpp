#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutant_compiler.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

// Line tables say which code an object has. Calls at the ends of lines would change with columns.
constexpr const char* flags = "-O1 -g1 -gno-column-info -w -DFAIRLIGHT_NO_FLATTEN";

std::string flat(std::string path) {
  for (char& c : path) c = c == '/' ? '_' : c;
  return path;
}

}  // namespace

int shell(const std::string& folder, const std::string& command) {
  return run_process({"sh", "-c", formatted("cd '%s' && %s", folder.c_str(), command.c_str())}).status;
}

std::string quoted(const std::string& path) { return formatted("'%s'", path.c_str()); }

Workplace::Workplace(const std::string& parent) : folder(parent + "/fairlight-mutate-XXXXXX") {
  if (mkdtemp(folder.data()) == nullptr)
    throw std::runtime_error("cannot make a folder in \"" + parent + "\" (is it full? TMPDIR names another)");
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

MutantCompiler::MutantCompiler(const BuildPlaces& places, const std::string& scratch)
    : places_(places), scratch_(scratch) {}

void MutantCompiler::begin(const Job& job) const {
  const fs::path file = fs::path(job.place.folder) / "include/fairlight" / job.mutant.file;
  fs::create_directories(file.parent_path());
  write_whole(file.string(), mutated(read_whole(places_.source + "/" + job.mutant.file), job.mutant));
}

std::string MutantCompiler::file_of(const Job& job, const BuiltObject& object) {
  return job.place.folder + "/" + flat(object.path);
}

bool MutantCompiler::compile(Job& job, const BuiltObject& object) {
  if (job.changed.contains(object.path)) return true;
  const std::string to = file_of(job, object);
  const std::string source = object.source == job.mutant.file
                                 ? job.place.folder + "/include/fairlight/" + object.source
                                 : places_.source + "/" + object.source;
  if (!compile_to(object, job.place.folder, source, to)) return false;
  shell(job.place.folder, formatted("strip --strip-debug %s", quoted(to).c_str()));
  job.changed[object.path] = read_whole(to) != unchanged(object).bytes;
  return true;
}

bool MutantCompiler::compile_to(const BuiltObject& object, const std::string& folder, const std::string& source,
                                const std::string& to) {
  static const std::regex own(" -c \\S+");
  const std::string command = std::regex_replace(
      BuiltObjects::with_options(with_header(object.command), formatted("-I%s/include", quoted(folder).c_str())),
      own, " -c " + quoted(source));
  return shell(places_.build, formatted("%s -include %s/validation/audit/mutation_values.h %s -o %s",
                                        command.c_str(), places_.source.c_str(), flags, quoted(to).c_str())) == 0;
}

// Precompiles the header that the command includes, with the options of the command, which halves
// the time. The precompiled header of the build has other optimisation options.
std::string MutantCompiler::with_header(const std::string& command) {
  static const std::regex include(R"( -include (\S+/cmake_pch\.hxx))"), source(" -c \\S+");
  std::smatch match;
  if (!std::regex_search(command, match, include)) return command;
  const std::lock_guard lock(headers_mutex_);
  std::string& header = headers_[match[1]];
  if (header.empty()) {
    const fs::path folder = fs::path(scratch_) / formatted("headers_%zu", headers_.size());
    fs::create_directories(folder);
    header = (folder / "cmake_pch.hxx").string();
    fs::copy_file(match[1].str(), header);
    const std::string options = std::regex_replace(std::regex_replace(command, include, ""), source, "");
    shell(places_.build, formatted("%s %s -x c++-header -o '%s.gch' -c '%s'", options.c_str(), flags,
                                   header.c_str(), header.c_str()));
  }
  return std::regex_replace(command, include, " -include " + header);
}

MutantCompiler::Unchanged& MutantCompiler::place_of(const BuiltObject& object) {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Unchanged>& place = unchanged_[object.path];
  if (!place) place = std::make_unique<Unchanged>();
  return *place;
}

void MutantCompiler::prepare(const std::vector<const BuiltObject*>& objects) {
  for (const BuiltObject* object : objects) {
    if (!place_of(*object).begun.exchange(true)) unchanged(*object);
  }
}

MutantCompiler::Unchanged& MutantCompiler::unchanged(const BuiltObject& object) {
  Unchanged& known = place_of(object);
  std::call_once(known.compiled, [&] {
    known.begun = true;
    const Workplace place(scratch_);
    const std::string to = place.folder + "/right.o";
    if (!compile_to(object, place.folder, places_.source + "/" + object.source, to))
      throw std::runtime_error("\"" + object.source + "\" does not compile as it is (build the program first)");
    read_lines(known, to);
    shell(place.folder, formatted("strip --strip-debug %s", quoted(to).c_str()));
    known.bytes = read_whole(to);
  });
  return known;
}

// Parses objdump's line table: the name of a file with a colon, then rows that begin with its last
// part and the line.
void MutantCompiler::read_lines(Unchanged& known, const std::string& object) const {
  static const std::string marks[] = {"/include/fairlight/", places_.source + "/"};
  std::istringstream lines(run_process({"objdump", "--dwarf=decodedline", object}).out);
  std::map<int, int>* code = nullptr;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(":")) {
      code = nullptr;
      for (const std::string& mark : marks) {
        const std::size_t at = line.find(mark);
        if (at == std::string::npos) continue;
        code = &known.code[line.substr(at + mark.size(), line.size() - 1 - at - mark.size())];
        break;
      }
    } else {
      std::istringstream words(line);
      std::string name;
      int number = 0;
      if (!(words >> name >> number)) continue;
      ++known.rows;
      if (code != nullptr) ++(*code)[number];
    }
  }
}

int MutantCompiler::code_in(const BuiltObject& object, const std::string& file, int first_line, int last_line) {
  const auto& code = unchanged(object).code;
  const auto found = code.find(file);
  if (found == code.end()) return 0;
  int rows = 0;
  for (auto line = found->second.lower_bound(first_line); line != found->second.end() && line->first <= last_line;
       ++line)
    rows += line->second;
  return rows;
}

int MutantCompiler::size_of(const BuiltObject& object) { return unchanged(object).rows; }

}  // namespace fairlight
