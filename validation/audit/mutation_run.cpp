#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutation_run.h>
#include <fairlight/validation/run/clock.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

constexpr const char* fate_names[] = {"killed", "killed by tests", "survived", "equivalent", "no program"};
constexpr std::size_t most_tests = 3, most_compiled_tests = 8;
constexpr int seconds_to_end = 30;  // after its time, a program is between two draws within these
constexpr int seconds_of_tests = 120;

constexpr std::string_view claims_folder = "validation/claims/";

bool is_claims(const std::string& source) { return source.starts_with(claims_folder); }

std::string list_of_sources(const BuiltObjects& objects, const std::vector<std::string>& paths) {
  std::string list;
  for (const std::string& path : paths) list += (list.empty() ? "" : " ") + objects.at(path).source;
  return list;
}

}  // namespace

const char* name(Fate::Kind kind) { return fate_names[static_cast<int>(kind)]; }

Fate::Kind fate_named(const std::string& name) {
  const auto* found = std::ranges::find(fate_names, name);
  if (found == std::end(fate_names)) throw std::invalid_argument("\"" + name + "\" is no fate of a mutant");
  return static_cast<Fate::Kind>(found - std::begin(fate_names));
}

MutationRun::MutationRun(const BuildPlaces& places, const MutationLimits& limits)
    : places_(places),
      limits_(limits),
      scratch_(fs::temp_directory_path().string()),
      objects_(places),
      compiler_(places, scratch_.folder),
      link_(objects_.link_command("fairlight")) {
  Sources sources(places);
  for (const Claim& claim : registry()) sources.files_of(claim.file);  // throws if one is newer than the program
}

Fate MutationRun::judge(const Mutant& mutant) {
  const Clock clock;
  MutantCompiler::Job job(scratch_.folder, mutant);
  compiler_.begin(job);
  Fate fate = judge_in(job);
  fate.seconds = clock.seconds();
  return fate;
}

// A .cpp is one object, all of whose code may have changed.
int MutationRun::code_of(const Mutant& mutant, const std::string& object, int first_line, int last_line) {
  const BuiltObject& built = objects_.at(object);
  return built.source == mutant.file ? 1 : compiler_.code_in(built, mutant.file, first_line, last_line);
}

// The objects with code from the function of the mutant, or else from its file. Line tables leave out
// what the compiler computes, such as constants, and may count a short function to its caller.
std::vector<std::string> MutationRun::with_code(const Mutant& mutant, const std::vector<std::string>& objects) {
  constexpr int last = 1 << 30;
  std::vector<const BuiltObject*> built;
  for (const std::string& object : objects) {
    if (objects_.at(object).source != mutant.file) built.push_back(&objects_.at(object));
  }
  compiler_.prepare(built);
  const std::pair<int, int> ranges[] = {{mutant.first_line, mutant.last_line}, {1, last}};
  for (const auto& [first_line, last_line] : ranges) {
    std::vector<std::string> found;
    std::ranges::copy_if(objects, std::back_inserter(found), [&](const std::string& object) {
      return code_of(mutant, object, first_line, last_line) > 0;
    });
    if (!found.empty()) return found;
  }
  return objects;
}

// The library objects that claims call and, if asked, those that run claims.
std::set<std::string> MutationRun::called_by(const std::string& claims, bool in_any_run) {
  const std::lock_guard lock(mutex_);
  std::set<std::string> called = objects_.called_by(claims);
  if (!in_any_run) return called;
  const std::string runner = objects_.of_source("validation/run/run_claims.cpp");
  called.insert(runner);
  std::ranges::copy(objects_.called_by(runner), std::inserter(called, called.end()));
  return called;
}

// The part of the code of a stage that is from the line of the mutant: files of claims about it have
// much of it, and compile fast.
double MutationRun::worth_of(const Mutant& mutant, const Stage& stage) {
  double code = 1, all = 1;
  for (const std::string& object : stage.objects) {
    if (is_claims(objects_.at(object).source)) code += code_of(mutant, object, mutant.line, mutant.line);
    all += compiler_.size_of(objects_.at(object));
  }
  return code / all;
}

// A file of claims with code from the mutant is a stage of its own, with the library objects that
// have such code and that it calls: the largest part of the code first. All claims that call such library
// objects but have no such code themselves run together, as they need not be compiled.
std::vector<MutationRun::Stage> MutationRun::stages_of(const Mutant& mutant, bool in_any_run) {
  std::map<std::string, std::set<std::string>> called;  // by object of claims
  std::set<std::string> reached;
  for (const Claim& claim : registry()) {
    const auto [own, is_new] = called.try_emplace(objects_.of_source("validation/claims/" + claim.file));
    if (!is_new) continue;
    own->second = called_by(own->first, in_any_run);
    own->second.insert(own->first);
    reached.insert(own->second.begin(), own->second.end());
  }
  std::vector<std::string> candidates;
  std::ranges::copy_if(objects_.with(mutant.file), std::back_inserter(candidates),
                       [&](const std::string& object) { return reached.contains(object); });
  const std::vector<std::string> concerned = with_code(mutant, candidates);
  std::vector<Stage> stages;
  Stage others;
  for (const auto& [own, all] : called) {
    const std::string file = objects_.at(own).source.substr(claims_folder.size());
    Stage stage{{file}, {}};
    std::ranges::copy_if(concerned, std::back_inserter(stage.objects),
                         [&, objects = &all](const std::string& object) { return objects->contains(object); });
    if (std::ranges::find(stage.objects, own) != stage.objects.end()) {
      stage.worth = worth_of(mutant, stage);
      stages.push_back(std::move(stage));
    } else if (!stage.objects.empty()) {
      others.claim_files.push_back(file);
      std::ranges::copy_if(stage.objects, std::back_inserter(others.objects), [&](const std::string& object) {
        return std::ranges::find(others.objects, object) == others.objects.end();
      });
    }
  }
  std::ranges::stable_sort(stages, std::greater(), &Stage::worth);
  if (!others.claim_files.empty())
    stages.insert(stages.begin() + std::min<std::ptrdiff_t>(1, std::ssize(stages)), others);
  return stages;
}

bool MutationRun::compile_all(MutantCompiler::Job& job, const std::vector<std::string>& objects) {
  return std::ranges::all_of(
      objects, [&](const std::string& object) { return compiler_.compile(job, objects_.at(object)); });
}

Fate MutationRun::judge_in(MutantCompiler::Job& job) {
  const Clock clock;
  std::string run;
  std::size_t files = 0;
  std::vector<Stage> stages = stages_of(job.mutant, false);
  if (stages.empty()) stages = stages_of(job.mutant, true);
  for (const Stage& stage : stages) {
    if (files == limits_.files || (files > 0 && clock.seconds() > limits_.seconds)) break;
    if (!compile_all(job, stage.objects)) return {Fate::Kind::no_program, list_of_sources(objects_, stage.objects)};
    if (std::ranges::none_of(stage.objects, [&](const std::string& object) { return job.changed.at(object); }))
      continue;
    const std::string by = killer(job, stage.claim_files);
    if (!by.empty()) return {Fate::Kind::killed, by};
    for (const std::string& file : stage.claim_files) run += (run.empty() ? "" : " ") + file;
    ++files;
  }
  return judge_by_tests(job, run);
}

Fate MutationRun::judge_by_tests(MutantCompiler::Job& job, std::string run) {
  std::vector<std::string> tests = objects_.tests_with(job.mutant.file);
  tests.resize(std::min(tests.size(), most_compiled_tests));
  std::size_t tests_run = 0;
  std::vector<std::string> library;
  std::ranges::copy_if(objects_.with(job.mutant.file), std::back_inserter(library),
                       [&](const std::string& object) { return !is_claims(objects_.at(object).source); });
  for (const std::string& test : tests) {
    if (tests_run == most_tests) break;
    std::vector<std::string> needed;
    {
      const std::lock_guard lock(mutex_);
      const std::set<std::string>& called = objects_.called_by(test);
      std::ranges::copy_if(library, std::back_inserter(needed),
                           [&](const std::string& object) { return called.contains(object); });
    }
    needed = with_code(job.mutant, needed);
    if (objects_.at(test).files.contains(job.mutant.file)) needed.push_back(test);
    if (!compile_all(job, needed)) return {Fate::Kind::no_program, objects_.at(test).source};
    if (std::ranges::none_of(needed, [&](const std::string& object) { return job.changed.at(object); })) continue;
    ++tests_run;
    if (test_fails(job, test, needed))
      return {Fate::Kind::killed_by_tests, objects_.at(test).source + (run.empty() ? "" : " after " + run)};
    run += (run.empty() ? "" : " ") + objects_.at(test).source;
  }
  if (job.changed.empty()) return {Fate::Kind::survived, "nothing: no claim and no test is built from it"};
  return run.empty() ? Fate{Fate::Kind::equivalent, ""} : Fate{Fate::Kind::survived, run};
}

// Links a program with changed objects before its own; a linker takes the first definition, and needs
// no object of an archive whose functions it has. Returns whether it could.
bool MutationRun::link(const MutantCompiler::Job& job, const std::string& command, const std::string& program,
                       const std::string& objects) const {
  const std::string to = formatted(" -o '%s/program' ", job.place.folder.c_str());
  return shell(places_.build, std::regex_replace(BuiltObjects::with_options(command, objects),
                                                 std::regex(" -o " + program + " "), to)) == 0;
}

// The name of a claim that fails, or how the program stopped. Empty if none fails.
std::string MutationRun::killer(const MutantCompiler::Job& job, const std::vector<std::string>& claim_files) const {
  std::string objects;
  for (const auto& [path, changed] : job.changed) {
    if (changed) objects += formatted(" %s", quoted(MutantCompiler::file_of(job, objects_.at(path))).c_str());
  }
  if (!link(job, link_, "fairlight", objects))
    throw std::runtime_error("fairlight cannot be linked with \"" + job.mutant.name() + "\" (try ninja)");
  std::string claims;
  for (const Claim& claim : registry()) {
    if (std::ranges::find(claim_files, claim.file) != claim_files.end())
      claims += formatted(" %s", quoted(claim.name).c_str());
  }
  const std::string findings = job.place.folder + "/findings.json";
  fs::remove(findings);
  const double seconds = std::min(limits_.seconds, limits_.verify * static_cast<double>(claim_files.size()));
  const std::string verify = formatted(
      "timeout %d ./program verify%s --seconds %g --fail-fast --instructions %s --threads 1 --json findings.json",
      static_cast<int>(seconds) + seconds_to_end, claims.c_str(), seconds, claimed_instructions().front().c_str());
  const int status = shell(job.place.folder, verify);
  if (!fs::exists(findings))
    return status == 124 ? "it does not end" : "it stopped with the status " + std::to_string(status);
  const auto outcomes = nlohmann::json::parse(read_whole(findings))["claims"];
  for (const auto& outcome : outcomes) {
    if (outcome["verdict"] == "biased") return outcome["name"];
  }
  for (const auto& outcome : outcomes) {
    if (outcome["verdict"] == "undecided" && !outcome["out_of_time"]) return outcome["name"];
  }
  return "";
}

// Links one test alone, by the link command of the program with all tests of its folder.
bool MutationRun::test_fails(const MutantCompiler::Job& job, const std::string& test,
                             const std::vector<std::string>& needed) const {
  static const std::regex own(R"( tests/CMakeFiles/\S+\.o\b)");
  const std::string program =
      "tests/" + fs::path(objects_.at(test).source).parent_path().filename().string() + "_tests";
  std::string objects = std::ranges::find(needed, test) == needed.end() ? test : "";
  for (const std::string& path : needed)
    objects += formatted(" %s", quoted(MutantCompiler::file_of(job, objects_.at(path))).c_str());
  if (!link(job, std::regex_replace(objects_.link_command(program), own, ""), program, objects))
    throw std::runtime_error(test + " cannot be linked with \"" + job.mutant.name() + "\" (try ninja)");
  return shell(job.place.folder, formatted("timeout %d ./program", seconds_of_tests)) != 0;
}

}  // namespace fairlight
