#include <chrono>
#include <stdexcept>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/run/since.h>
#include <fairlight/validation/run/sources.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

using testing::TemporaryFolder;
using testing::write_file;
namespace fs = std::filesystem;

// A tree with two files of claims, and a build of it, whose compiler says what a source includes and does nothing else.
class Tree {
 public:
  Tree() {
    write("validation/claims/cones.cpp", "cones");
    write("validation/claims/scenes.cpp", "scenes");
    write("validation/checks/means.h", "checks");
    write("validation/checks/packet_mean.cpp", "#include <fairlight/validation/checks/means.h>\n");
    write("estimators/cone.h", "cone");
    write("stats/mean_test.h", "means");
    write("stats/mean_test.cpp", "means");
    write("stats/moments.h", "moments");
    write("render/image.h", "image");
    write("render/image.cpp", "image");
    write("render/packets.cpp", "#include <fairlight/render/tracer.h>\n");
    write("render/tracer.h", "tracer");
    write("render/unused.cpp", "#include <fairlight/render/unused_parts.h>\n");
    write("render/unused_parts.h", "unused");
    build_ = "rule cc\n  command = cp $in.d $out.d && touch $out\n  depfile = $out.d\n  deps = gcc\n";
    compile("validation/claims/cones.cpp", {"validation/checks/means.h", "estimators/cone.h", "stats/mean_test.h"});
    compile("validation/claims/scenes.cpp", {"validation/checks/means.h", "render/image.h"});
    compile("validation/checks/packet_mean.cpp", {"validation/checks/means.h"});
    compile("stats/mean_test.cpp", {"stats/mean_test.h", "stats/moments.h"});
    compile("render/image.cpp", {"render/image.h", "render/tracer.h"});
    compile("render/packets.cpp", {"render/tracer.h", "estimators/cone.h"});
    compile("render/unused.cpp", {"render/unused_parts.h"});
    write("build/build.ninja", build_);
    write("build/generated/version.h", "1");
    fs::create_directories(folder_.path() / "build/include");
    fs::create_directory_symlink(folder_.path(), folder_.path() / "build/include/fairlight");
    if (run_process({"ninja", "-C", folder_ / "build"}).status != 0) throw std::runtime_error("ninja failed");
    write("program", "");
    fs::last_write_time(folder_.path() / "program", fs::file_time_type::clock::now() + std::chrono::hours(1));
  }

  void write(const std::string& file, const std::string& text) { write_file(folder_ / file, text); }
  BuildPlaces places() const { return {folder_ / "build", folder_.path().string(), folder_ / "program"}; }
  std::string path(const std::string& file) const { return folder_ / file; }

  void git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"git", "-C", folder_.path().string(), "-c", "user.name=t", "-c", "user.email=t@t"});
    if (run_process(arguments).status != 0) throw std::runtime_error("git failed");
  }
  void commit() const {
    write_file(folder_ / ".gitignore", "build\nprogram\n");
    git({"init", "-q"});
    git({"add", "-A"});
    git({"commit", "-q", "-m", "all"});
  }

 private:
  // The build names headers through its own folder of links, and the compiler's too.
  void compile(const std::string& source, const std::vector<std::string>& headers) {
    std::string needs = "x.o: " + path(source) + " /usr/include/stdio.h generated/version.h";
    for (const std::string& header : headers) needs += " include/fairlight/" + header;
    write(source + ".d", needs + "\n");
    build_ += "build " + source + ".o: cc " + path(source) + "\n";
  }

  TemporaryFolder folder_;
  std::string build_;
};

using Files = std::set<std::string>;

TEST(Sources, AreWhatAClaimIncludesAndTheSourcesBehindIt) {
  const Tree tree;
  Sources sources(tree.places());
  EXPECT_EQ(sources.files_of("cones.cpp"),
            (Files{"validation/claims/cones.cpp", "validation/checks/means.h", "validation/checks/packet_mean.cpp",
                   "estimators/cone.h", "stats/mean_test.h", "stats/mean_test.cpp", "stats/moments.h"}));
  EXPECT_EQ(
      sources.files_of("scenes.cpp"),
      (Files{"validation/claims/scenes.cpp", "validation/checks/means.h", "validation/checks/packet_mean.cpp",
             "render/image.h", "render/image.cpp", "render/tracer.h", "render/packets.cpp", "estimators/cone.h"}));
}

TEST(Sources, HaveAnotherContentWhenAnyOfThemChanges) {
  Tree tree;
  const auto content = [&](const char* file) { return Sources(tree.places()).content(file); };
  const std::uint64_t cones = content("cones.cpp");
  const std::uint64_t scenes = content("scenes.cpp");
  EXPECT_NE(cones, scenes);
  EXPECT_EQ(content("cones.cpp"), cones);
  tree.write("stats/moments.h", "other moments");
  EXPECT_NE(content("cones.cpp"), cones);
  EXPECT_EQ(content("scenes.cpp"), scenes);
  tree.write("stats/moments.h", "moments");
  EXPECT_EQ(content("cones.cpp"), cones);
}

std::string refusal(const BuildPlaces& places, const std::string& file) {
  try {
    Sources(places).files_of(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Sources, AreNotKnownWithoutTheBuild) {
  const Tree tree;
  const TemporaryFolder elsewhere;
  BuildPlaces places = tree.places();
  places.build = elsewhere / "gone";
  EXPECT_NE(refusal(places, "cones.cpp").find("gone"), std::string::npos);
  places = tree.places();
  places.source = elsewhere.path().string();
  EXPECT_NE(refusal(places, "cones.cpp"), "");
  EXPECT_NE(refusal(tree.places(), "lights.cpp").find("lights.cpp"), std::string::npos);
}

TEST(Sources, AreNotThoseOfAnOlderProgram) {
  const Tree tree;
  fs::last_write_time(tree.path("stats/moments.h"), fs::file_time_type::clock::now() + std::chrono::hours(2));
  EXPECT_NE(refusal(tree.places(), "cones.cpp").find("stats/moments.h"), std::string::npos);
  EXPECT_EQ(refusal(tree.places(), "scenes.cpp"), "");
  fs::remove(tree.path("render/tracer.h"));
  EXPECT_NE(refusal(tree.places(), "scenes.cpp").find("render/tracer.h"), std::string::npos);
}

std::vector<std::string> touched(const Tree& tree, const std::string& revision) {
  Claim cones{
      .name = "cones", .kind = "", .subjects = {}, .statement = "", .source = "", .margin_factor = 1, .check = {}};
  cones.file = "cones.cpp";
  Claim scenes = cones;
  scenes.name = "scenes";
  scenes.file = "scenes.cpp";
  std::vector<std::string> names;
  for (const Claim* claim : claims_since(revision, {&cones, &scenes}, tree.places())) names.push_back(claim->name);
  return names;
}

TEST(ClaimsSince, AreThoseWhoseSourcesDiffer) {
  Tree tree;
  tree.commit();
  using Names = std::vector<std::string>;
  EXPECT_EQ(touched(tree, "HEAD"), Names{});
  tree.write("render/unused.cpp", "changed");
  EXPECT_EQ(touched(tree, "HEAD"), Names{});
  tree.write("render/packets.cpp", "#include <fairlight/render/tracer.h>\n// changed\n");
  EXPECT_EQ(touched(tree, "HEAD"), Names{"scenes"});
  tree.write("validation/checks/means.h", "changed");
  EXPECT_EQ(touched(tree, "HEAD"), (Names{"cones", "scenes"}));
  tree.git({"commit", "-q", "-a", "-m", "more"});
  EXPECT_EQ(touched(tree, "HEAD"), Names{});
  EXPECT_EQ(touched(tree, "HEAD~1"), (Names{"cones", "scenes"}));
}

TEST(ClaimsSince, CountNewFiles) {
  Tree tree;
  fs::rename(tree.path("stats/moments.h"), tree.path("away"));
  tree.commit();
  tree.write("stats/moments.h", "moments");
  EXPECT_EQ(touched(tree, "HEAD"), std::vector<std::string>{"cones"});
}

TEST(FilesChangedSince, RefusesWhatIsNoRevision) {
  const Tree tree;
  const auto refuses = [&](const std::string& revision) {
    EXPECT_THROW(files_changed_since(revision, tree.path("")), std::runtime_error) << revision;
  };
  refuses("HEAD");  // no repository
  tree.commit();
  for (const char* revision : {"nope", "", "--output=x", "-h", "HEAD; touch x", "$(touch x)", "HEAD:stats"})
    refuses(revision);
  EXPECT_FALSE(fs::exists(tree.path("x")));
  EXPECT_NO_THROW(files_changed_since("HEAD", tree.path("")));
}

TEST(RunProcess, GivesItsArgumentsToTheProgramAsTheyAre) {
  const ProcessResult result = run_process({"printf", "%s|", "a b", "$HOME", "; exit 3"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "a b|$HOME|; exit 3|");
  const ProcessResult failure = run_process({"sh", "-c", "echo out; echo why >&2; exit 7"});
  EXPECT_EQ(failure.status, 7);
  EXPECT_EQ(failure.out, "out\n");
  EXPECT_EQ(failure.error, "why\n");
  EXPECT_EQ(run_process({"sh", "-c", "head -c 1000000 /dev/zero >&2"}).error.size(), 1'000'000u);
  EXPECT_EQ(run_process({"sh", "-c", "kill -9 $$"}).status, 137);
  EXPECT_THROW(run_process({"no-such-program-anywhere"}), std::runtime_error);
}

}  // namespace
}  // namespace fairlight
