#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/mutant_compiler.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using testing::TemporaryFolder;
using testing::write_file;
namespace fs = std::filesystem;

// A tree with a library of one header and one source, two files of claims of which one calls the
// library, and two tests; and a build of it.
class Tree {
 public:
  Tree() {
    fs::create_directories(folder_.path() / "build/include");
    fs::create_directory_symlink(folder_.path(), folder_.path() / "build/include/fairlight");
    write_file(folder_ / "validation/audit/mutation_values.h", "");
    write_file(
        folder_ / "stats/sum.h",
        "#pragma once\nint sum(int n);\nint other(int n);\ninline int twice(int n) {\n  return other(n + n);\n}\n");
    write_file(folder_ / "stats/other.h", "#pragma once\n");
    write("stats/sum.cpp", "#include <fairlight/stats/sum.h>\nint sum(int n) {\n  return twice(n) - 1;\n}\n");
    write("validation/claims/sums.cpp", "#include <fairlight/stats/sum.h>\nint claims() { return sum(3); }\n");
    write("validation/claims/none.cpp", "int no_claims() { return 3; }\n");
    write("tests/stats/all_test.cpp", "#include <fairlight/stats/other.h>\n#include <fairlight/stats/sum.h>\n");
    write("tests/stats/sum_test.cpp", "#include <fairlight/stats/sum.h>\n");
    write_file(folder_ / "build/build.ninja",
               "rule cc\n  command = $cc -MD -MF $out.d\n  depfile = $out.d\n  deps = gcc\n" + rules_);
    write_file(folder_ / "build/compile_commands.json", "[" + commands_ + "]");
    if (run_process({"ninja", "-C", folder_ / "build"}).status != 0) throw std::runtime_error("ninja failed");
  }

  BuildPlaces places() const { return {folder_ / "build", folder_.path().string(), folder_ / "program"}; }
  std::string scratch() const { return folder_.path().string(); }

 private:
  void write(const std::string& file, const std::string& text) {
    const std::string source = folder_ / file;
    write_file(source, text);
    const std::string command =
        formatted("c++ -I%s -O1 -o %s.o -c %s", (folder_ / "build/include").c_str(), file.c_str(), source.c_str());
    rules_ += formatted("build %s.o: cc %s\n  cc = %s\n", file.c_str(), source.c_str(), command.c_str());
    commands_ += formatted("%s{\"file\": \"%s\", \"command\": \"%s\"}", commands_.empty() ? "" : ",",
                           source.c_str(), command.c_str());
  }

  TemporaryFolder folder_;
  std::string rules_, commands_;
};

// A change of a text in a file that has it once.
Mutant change(const Tree& tree, const std::string& file, const std::string& before, const std::string& after) {
  std::string text = run_process({"cat", tree.places().source + "/" + file}).out;
  Mutant mutant;
  mutant.file = file;
  mutant.begin = text.find(before);
  mutant.length = before.size();
  mutant.replacement = after;
  return mutant;
}

TEST(BuiltObjects, KnowWhatWasBuiltFromAFile) {
  const Tree tree;
  BuiltObjects objects(tree.places());
  EXPECT_THAT(objects.with("stats/sum.h"), ElementsAre("stats/sum.cpp.o", "validation/claims/sums.cpp.o"));
  EXPECT_THAT(objects.with("stats/sum.cpp"), ElementsAre("stats/sum.cpp.o"));
  EXPECT_EQ(objects.of_source("stats/sum.cpp"), "stats/sum.cpp.o");
  EXPECT_THROW(objects.of_source("stats/none.cpp"), std::runtime_error);
}

TEST(BuiltObjects, KnowWhatAnObjectCalls) {
  const Tree tree;
  BuiltObjects objects(tree.places());
  EXPECT_THAT(objects.called_by("validation/claims/sums.cpp.o"), ElementsAre("stats/sum.cpp.o"));
  EXPECT_THAT(objects.called_by("validation/claims/none.cpp.o"), ElementsAre());
}

TEST(BuiltObjects, TakeTheMostSpecificTestsFirst) {
  const Tree tree;
  const BuiltObjects objects(tree.places());
  for (const char* file : {"stats/sum.h", "stats/sum.cpp"})
    EXPECT_THAT(objects.tests_with(file), ElementsAre("tests/stats/sum_test.cpp.o", "tests/stats/all_test.cpp.o"));
}

TEST(BuiltObjects, RefuseAProgramThatTheBuildDoesNotKnow) {
  const Tree tree;
  EXPECT_THROW(BuiltObjects(tree.places()).link_command("nothing"), std::runtime_error);
}

TEST(MutantCompiler, CompilesTheChangedText) {
  const Tree tree;
  const BuiltObjects objects(tree.places());
  MutantCompiler compiler(tree.places(), tree.scratch());
  const auto changed = [&](const Mutant& mutant, const std::string& object) {
    MutantCompiler::Job job(tree.scratch(), mutant);
    compiler.begin(job);
    return compiler.compile(job, objects.at(object)) ? std::to_string(job.changed.at(object)) : "no program";
  };
  EXPECT_EQ(changed(change(tree, "stats/sum.cpp", "- 1", "- 2"), "stats/sum.cpp.o"), "1");
  EXPECT_EQ(changed(change(tree, "stats/sum.h", "n + n", "n"), "stats/sum.cpp.o"), "1") << "by a header";
  EXPECT_EQ(changed(change(tree, "stats/sum.h", "n + n", "n * 2"), "stats/sum.cpp.o"), "0") << "it is the same";
  EXPECT_EQ(changed(change(tree, "stats/sum.h", "n + n", "m"), "stats/sum.cpp.o"), "no program");
}

TEST(MutantCompiler, KnowsWhichLinesAnObjectHasCodeFrom) {
  const Tree tree;
  const BuiltObjects objects(tree.places());
  MutantCompiler compiler(tree.places(), tree.scratch());
  EXPECT_GT(compiler.code_in(objects.at("stats/sum.cpp.o"), "stats/sum.h", 5, 5), 0) << "inlined";
  EXPECT_EQ(compiler.code_in(objects.at("stats/sum.cpp.o"), "stats/sum.h", 1, 3), 0);
  EXPECT_EQ(compiler.code_in(objects.at("validation/claims/sums.cpp.o"), "stats/sum.h", 1, 9), 0);
}

}  // namespace
}  // namespace fairlight
