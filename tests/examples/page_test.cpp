#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/house.h>
#include <support/temporary_folder.h>

#include <fairlight/stats/seed.h>
#include <fairlight/validation/faults/catalogue.h>

// docs/adding_an_estimator.md, as it stands: its files are compiled with this one.
namespace fairlight {

void add_cosine_squared_claims(std::vector<Claim>& claims);
std::vector<Fault> cosine_squared_faults();

namespace {

Finding run(const Claim& claim, std::uint64_t seed) {
  return claim.check({claim.name, seed, 1e-9, 0.01, 1e-3 * claim.margin_factor});
}

std::vector<Claim> claims() {
  std::vector<Claim> all;
  add_cosine_squared_claims(all);
  return all;
}

TEST(ThePage, AddsClaimsThatAreCertified) {
  const std::uint64_t seed = fresh_seed();
  for (const Claim& claim : claims()) {
    const Finding finding = run(claim, seed);
    EXPECT_EQ(finding.verdict, Verdict::certified)
        << claim.name << " seed " << seed_text(seed) << " " << finding.note;
  }
}

TEST(ThePage, AddsAFaultThatIsCaught) {
  const std::uint64_t seed = fresh_seed();
  for (const Fault& fault : cosine_squared_faults()) {
    for (const Claim& claim : fault.claims) {
      EXPECT_EQ(run(claim, seed).verdict, Verdict::biased) << claim.name << " seed " << seed_text(seed);
    }
  }
}

// The lines after which the page puts its own are where it says.
TEST(ThePage, KnowsWhereItsLinesGo) {
  const auto holds = [](const std::string& file, const std::string& line) {
    const std::string page = testing::read_file(FAIRLIGHT_SOURCE_DIR "/docs/adding_an_estimator.md");
    const std::string source = testing::read_file(FAIRLIGHT_SOURCE_DIR "/" + file);
    return page.find("`" + file + "`") != std::string::npos && page.find("`" + line + "`") != std::string::npos &&
           source.find(line) != std::string::npos;
  };
  EXPECT_TRUE(holds("validation/claims/claims.h", "void add_direction_claims(std::vector<Claim>& claims);"));
  EXPECT_TRUE(holds("validation/claims/claims.h", R"({"directions.cpp", add_direction_claims},)"));
  EXPECT_TRUE(holds("validation/faults/catalogue.h", "std::vector<Fault> direction_faults();"));
  EXPECT_TRUE(holds("validation/faults/catalogue.cpp", "direction_faults,"));
}

TEST(ThePage, LeavesNoPaperMissing) {
  std::set<std::string> subjects;
  for (const Claim& claim : claims()) subjects.insert(claim.subjects.begin(), claim.subjects.end());
  EXPECT_THAT(testing::unregistered_components(FAIRLIGHT_PAGE_DIR, subjects), ::testing::IsEmpty());
}

}  // namespace
}  // namespace fairlight
