#include <gtest/gtest.h>

#include <fairlight/stats/seed.h>
#include <fairlight/validation/audit/ledger_audit.h>
#include <fairlight/validation/audit/tester_audit.h>

// A short form of `fairlight audit calibration` and `audit power`.
namespace fairlight {
namespace {

TesterAudit brief() { return {fresh_seed(), 2, 200, 10, 10, 20000}; }

TEST(TesterAudit, RightCodeFailsNoMoreOftenThanItMay) {
  const TesterAudit audit = brief();
  const auto outcomes = audit_calibration(audit);
  EXPECT_FALSE(outcomes.empty());
  for (const TesterOutcome& o : outcomes) {
    EXPECT_TRUE(o.passed()) << o.name << ": " << o.failures << " of " << o.runs << ", seed "
                            << seed_text(audit.seed);
  }
}

TEST(TesterAudit, WrongCodeIsNotMissed) {
  const TesterAudit audit = brief();
  const auto outcomes = audit_power(audit);
  EXPECT_FALSE(outcomes.empty());
  for (const TesterOutcome& o : outcomes) {
    EXPECT_TRUE(o.passed()) << o.name << ": " << o.failures << " of " << o.runs << ", seed "
                            << seed_text(audit.seed);
  }
}

TEST(TesterAudit, ASigmaFivePercentTooSmallIsFoundOut) {
  const TesterAudit audit = brief();
  const auto outcomes = audit_uniformity(audit);
  EXPECT_FALSE(outcomes.empty());
  for (const UniformityOutcome& o : outcomes) {
    EXPECT_EQ(o.uniform, o.expected) << o.name << ", p = " << o.least << ", seed " << seed_text(audit.seed);
  }
}

TEST(TesterAudit, LedgersFindWhatRunsDoNot) {
  TesterAudit audit = brief();
  audit.power_seeds = 40;
  const auto outcomes = audit_ledger(audit);
  EXPECT_FALSE(outcomes.empty());
  for (const LedgerOutcome& o : outcomes) {
    EXPECT_TRUE(o.passed()) << "bias " << o.bias << ": " << o.ledgers_biased << " of " << o.ledgers
                            << " ledgers biased, " << o.median_finer << " times finer, seed "
                            << seed_text(audit.seed);
  }
}

TEST(FixedSizeCost, IsThatOfTheDesign) { EXPECT_NEAR(fixed_size_cost(1e-8, 0.01), 65, 0.2); }

}  // namespace
}  // namespace fairlight
