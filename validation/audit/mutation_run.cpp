#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <regex>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutation_run.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

constexpr const char* fate_names[] = {"killed", "survived", "equivalent", "no program"};

std::string quoted(const std::string& path) { return formatted("'%s'", path.c_str()); }

int shell(const std::string& folder, const std::string& command) {
  return run_process({"sh", "-c", formatted("cd '%s' && %s", folder.c_str(), command.c_str())}).status;
}

constexpr std::string_view claims_folder = "validation/claims/";

// The command that compiles each source for the baseline instruction set, without the name of the
// object.
std::map<std::string, std::string> compile_commands(const BuildPlaces& places) {
  std::map<std::string, std::string> commands;
  for (const auto& entry : nlohmann::json::parse(read_whole(places.build + "/compile_commands.json"))) {
    const std::string file = entry["file"], command = entry["command"];
    if (!file.starts_with(places.source + "/") || command.find("FAIRLIGHT_ENTRY") != std::string::npos) continue;
    commands[file.substr(places.source.size() + 1)] = std::regex_replace(command, std::regex(" -o \\S+"), "");
  }
  return commands;
}

// The command that links one of the programs of the build.
std::string link_command(const BuildPlaces& places, const std::string& program) {
  const std::string all = run_process({"ninja", "-C", places.build, "-t", "commands", program}).out;
  const std::size_t end = all.find_last_not_of('\n') + 1;
  const std::size_t begin = all.rfind('\n', end - 1) + 1;
  std::string last = all.substr(begin, end - begin);
  if (last.find(formatted(" -o %s ", program.c_str())) == std::string::npos) {
    throw std::runtime_error("it is not known how \"" + places.build + "\" links " + program +
                             " (build it with ninja)");
  }
  return last;
}

// Adds options after the name of the compiler, which is the first word with a path.
std::string with_options(const std::string& command, const std::string& options) {
  static const std::regex compiler(R"(^((?:: && )?\S+))");
  return std::regex_replace(command, compiler, "$1 " + options, std::regex_constants::format_first_only);
}

std::vector<std::string> components_of(const std::string& text) {
  static const std::regex declaration(R"((?:^|\n)(?:struct|class) (\w+))");
  std::vector<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match)
    names.push_back((*match)[1]);
  return names;
}

}  // namespace

const char* name(Fate::Kind kind) { return fate_names[static_cast<int>(kind)]; }

Fate::Kind fate_named(const std::string& name) {
  const auto* found = std::ranges::find(fate_names, name);
  if (found == std::end(fate_names)) throw std::invalid_argument("\"" + name + "\" is no fate of a mutant");
  return static_cast<Fate::Kind>(found - std::begin(fate_names));
}

MutationRun::Workplace::Workplace(const std::string& parent) : folder(parent + "/fairlight-mutate-XXXXXX") {
  if (mkdtemp(folder.data()) == nullptr)
    throw std::runtime_error("cannot make a folder in \"" + parent + "\" (is it full? TMPDIR names another)");
}

MutationRun::Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

MutationRun::MutationRun(const BuildPlaces& places)
    : places_(places),
      scratch_(fs::temp_directory_path().string()),
      link_(link_command(places, "fairlight")),
      sources_(places),
      compile_(compile_commands(places)) {
  for (const Claim& claim : registry()) sources_.files_of(claim.file);  // throws if one is newer than the program
}

std::vector<std::string> MutationRun::concerned(const std::string& source) {
  const std::lock_guard lock(mutex_);
  const std::vector<std::string> names = components_of(read_whole(places_.source + "/" + source));
  std::map<std::string, int> about;
  for (const Claim& claim : registry()) {
    if (!sources_.files_of(claim.file).contains(source)) continue;
    about[claim.file] += static_cast<int>(std::ranges::count_if(claim.subjects, [&](const std::string& subject) {
      return std::ranges::find(names, subject) != names.end();
    }));
  }
  std::vector<std::string> files;
  for (const auto& [file, claims] : about) files.push_back(file);
  std::ranges::stable_sort(files, [&](const std::string& a, const std::string& b) { return about[a] > about[b]; });
  return files;
}

std::vector<std::string> MutationRun::tests_of(const std::string& source) const {
  const std::vector<std::string> names = components_of(read_whole(places_.source + "/" + source));
  const std::string stem = "tests/" + fs::path(source).replace_extension().string();
  std::vector<std::pair<std::ptrdiff_t, std::string>> about;
  for (const auto& [file, command] : compile_) {
    if (!file.starts_with(fs::path(stem).parent_path().string() + "/")) continue;
    const std::string text = read_whole(places_.source + "/" + file);
    std::ptrdiff_t mentions = file == stem + "_test.cpp" ? 1000 : 0;
    for (const std::string& name : names) {
      const std::regex mention("\\b" + name + "\\b");
      mentions += std::distance(std::sregex_iterator(text.begin(), text.end(), mention), std::sregex_iterator());
    }
    if (mentions > 0) about.emplace_back(-mentions, file);
  }
  std::ranges::sort(about);
  about.resize(std::min<std::size_t>(about.size(), 3));
  std::vector<std::string> tests;
  for (const auto& [order, file] : about) tests.push_back(file);
  return tests;
}

Fate MutationRun::judge(const Mutant& mutant, std::size_t most_files) {
  const auto start = std::chrono::steady_clock::now();
  const Workplace place(scratch_.folder);
  Fate fate = judge_in(place, mutant, most_files);
  fate.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return fate;
}

Fate MutationRun::judge_in(const Workplace& place, const Mutant& mutant, std::size_t most_files) {
  const fs::path header = fs::path(place.folder) / "include/fairlight" / mutant.file;
  fs::create_directories(header.parent_path());
  write_whole(header.string(), mutated(read_whole(places_.source + "/" + mutant.file), mutant));
  std::vector<std::string> files = concerned(mutant.file);
  for (std::string& file : files) file.insert(0, claims_folder);
  const std::vector<std::string> tests =
      tests_of(mutant.file);  // a test takes less time than another file of claims
  files.insert(files.begin() + std::min<std::ptrdiff_t>(1, std::ssize(files)), tests.begin(), tests.end());
  std::string run;
  std::size_t of_claims = 0;
  for (const std::string& file : files) {
    const bool is_test = !file.starts_with(claims_folder);
    if (!is_test && of_claims == most_files) continue;
    if (!compile(place, file)) return {Fate::Kind::no_program, file};
    if (same_as_unchanged(place, file)) continue;
    const std::string by = is_test ? failing_test(place, file) : killer(place, file.substr(claims_folder.size()));
    if (!by.empty()) return {Fate::Kind::killed, by};
    run += (run.empty() ? "" : " ") + file;
    of_claims += is_test ? 0 : 1;
  }
  return run.empty() ? Fate{Fate::Kind::equivalent, ""} : Fate{Fate::Kind::survived, run};
}

// Of a file of claims, the object also holds the bodies that the claims call and that other files
// compile: those of the mutant take the place of those in the library.
bool MutationRun::compile(const Workplace& place, const std::string& source) {
  if (!source.starts_with(claims_folder)) return compile_to(place, source, place.object());
  std::string objects = quoted(place.folder + "/claims.o");
  if (!compile_to(place, source, place.folder + "/claims.o")) return false;
  for (const char* body : {"chosen_tracer", "draws", "pairs"}) {
    const std::string object = formatted("%s/%s.o", place.folder.c_str(), body);
    if (!fs::exists(object) && !compile_to(place, formatted("validation/checks/%s.cpp", body), object))
      return false;
    objects += formatted(" %s", quoted(object).c_str());
  }
  return shell(place.folder, formatted("ld -r -o %s %s", quoted(place.object()).c_str(), objects.c_str())) == 0;
}

bool MutationRun::compile_to(const Workplace& place, const std::string& source, const std::string& object) {
  const std::string command =
      with_options(parsed_once(compile_.at(source)), formatted("-I%s/include", quoted(place.folder).c_str()));
  return shell(places_.build, formatted("%s -O1 -w -o '%s'", command.c_str(), object.c_str())) == 0;
}

// Precompiles the header that the command includes, with the options of the command, which halves
// the time. The precompiled header of the build has other optimisation options.
std::string MutationRun::parsed_once(const std::string& command) {
  static const std::regex include(R"( -include (\S+/cmake_pch\.hxx))"), source(" -c \\S+");
  std::smatch match;
  if (!std::regex_search(command, match, include)) return command;
  const std::lock_guard lock(mutex_);
  std::string& header = headers_[match[1]];
  if (header.empty()) {
    const fs::path folder = fs::path(scratch_.folder) / formatted("headers_%zu", headers_.size());
    fs::create_directories(folder);
    header = (folder / "cmake_pch.hxx").string();
    fs::copy_file(match[1].str(), header);
    const std::string options = std::regex_replace(std::regex_replace(command, include, ""), source, "");
    shell(places_.build, formatted("%s -O1 -w -x c++-header -o '%s.gch' -c '%s'", options.c_str(), header.c_str(),
                                   header.c_str()));
  }
  return std::regex_replace(command, include, " -include " + header);
}

// Whether the changed object equals that of the right source. Compiles the latter once.
bool MutationRun::same_as_unchanged(const Workplace& place, const std::string& source) {
  const std::lock_guard lock(unchanged_);
  const std::string object = (fs::path(scratch_.folder) / fs::path(source).filename()).string() + ".o";
  if (!fs::exists(object)) {
    const Workplace unchanged(scratch_.folder);
    if (!compile(unchanged, source))
      throw std::runtime_error("\"" + source + "\" does not compile as it is (build the program first)");
    fs::rename(unchanged.object(), object);
  }
  return read_whole(object) == read_whole(place.object());
}

void MutationRun::link(const Workplace& place, const std::string& command, const std::string& program) const {
  const std::string link =
      std::regex_replace(with_options(command, quoted(place.object())), std::regex(" -o " + program + " "),
                         formatted(" -o '%s' ", place.program().c_str()));
  if (shell(places_.build, link) != 0)
    throw std::runtime_error(program + " cannot be linked with a changed source (try ninja)");
}

// The name of a claim that is biased, or how the program stopped. Empty if all are certified.
std::string MutationRun::killer(const Workplace& place, const std::string& claim_file) const {
  link(place, link_, "fairlight");
  std::string claims;
  for (const Claim& claim : registry()) {
    if (claim.file == claim_file) claims += formatted(" %s", quoted(claim.name).c_str());
  }
  for (const char* seconds : {" --seconds 10", ""}) {
    const std::string verify =
        formatted("timeout 600 ./fairlight verify%s%s --instructions %s --threads 1 --json findings.json",
                  claims.c_str(), seconds, claimed_instructions().front().c_str());
    const int status = shell(place.folder, verify);
    if (status != 0 && !fs::exists(place.folder + "/findings.json"))
      return "it stopped with the status " + std::to_string(status);
    if (status == 0) return "";
    const auto findings = nlohmann::json::parse(read_whole(place.folder + "/findings.json"));
    for (const auto& finding : findings["claims"]) {
      if (finding["verdict"] == "biased") return finding["name"];
    }
    fs::remove(place.folder + "/findings.json");
  }
  return "no verdict";
}

// The source of the test if it fails. Links this test alone, by the link command of the program
// with all tests of its folder.
std::string MutationRun::failing_test(const Workplace& place, const std::string& test) const {
  static const std::regex objects(R"( tests/CMakeFiles/\S+\.o\b)");
  const std::string program = fs::path(test).parent_path().string() + "_tests";
  link(place, std::regex_replace(link_command(places_, program), objects, ""), program);
  return shell(place.folder, "timeout 600 ./fairlight") == 0 ? "" : test;
}

}  // namespace fairlight
