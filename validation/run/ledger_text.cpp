#include <charconv>
#include <cmath>
#include <limits>

#include <fairlight/stats/hash.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/run/ledger_text.h>

namespace fairlight {
namespace {

constexpr double unit = 0x1p-10;

// Rounds down, so that a reader sees no more evidence than there is.
void put(std::string& line, double log_wealth) {
  line += ' ';
  line += std::isinf(log_wealth) ? "inf" : std::to_string(static_cast<long long>(std::floor(log_wealth / unit)));
}

// Reads the words of a line, one after the other.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  bool good() const { return good_; }
  bool done() const { return rest_.empty(); }

  std::string_view next(char end = ' ') {
    const std::size_t length = std::min(rest_.find(end), rest_.size());
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    good_ = good_ && !word.empty();
    return word;
  }

  template <class Number>
  Number number(std::string_view word, int base = 10) {
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value, base);
    good_ = good_ && result.ec == std::errc() && result.ptr == word.data() + word.size();
    return value;
  }

  double log_wealth() {
    const std::string_view word = next();
    return word == "inf" ? std::numeric_limits<double>::infinity()
                         : unit * static_cast<double>(number<long long>(word));
  }

 private:
  std::string_view rest_;
  bool good_ = true;
};

std::set<std::uint64_t> seeds_of(Words& words) {
  std::set<std::uint64_t> seeds;
  Words list(words.next());
  while (!list.done()) seeds.insert(words.number<std::uint64_t>(list.next(','), 16));
  return seeds;
}

// Reads the margin grids of all channels, which have the same length, to the end of the line.
EvidenceSum evidence_sum_of(Words& words, bool run) {
  const int first = words.number<int>(words.next());
  const auto channels = words.number<std::size_t>(words.next());
  std::vector<EvidenceSum::Sum> sums;
  while (words.good() && !words.done()) {
    EvidenceSum::Sum sum;
    sum.total.above_reference = words.log_wealth();
    sum.total.below_reference = words.log_wealth();
    sum.total.below_upper_margin = words.log_wealth();
    sum.total.above_lower_margin = words.log_wealth();
    sum.below_upper_margin = run ? std::max(0.0, sum.total.below_upper_margin) : words.log_wealth();
    sum.above_lower_margin = run ? std::max(0.0, sum.total.above_lower_margin) : words.log_wealth();
    sums.push_back(sum);
  }
  if (!words.good() || channels == 0 || sums.empty() || sums.size() % channels != 0) return {};
  const std::size_t length = sums.size() / channels;
  if (first < 0 || static_cast<std::size_t>(first) + length > static_cast<std::size_t>(margin_levels)) return {};
  std::vector<std::vector<EvidenceSum::Sum>> grids;
  for (std::size_t c = 0; c < channels; ++c) {
    const auto begin = sums.begin() + static_cast<std::ptrdiff_t>(c * length);
    grids.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(length));
  }
  return {first, std::move(grids)};
}

}  // namespace

std::string line_of(const LedgerEntry& entry) {
  const bool run = entry.seeds.size() == 1;
  std::string line = (run ? "run " : "sum ") + entry.claim + " " + seed_text(entry.content) + " ";
  for (std::uint64_t seed : entry.seeds) line += (line.back() == ' ' ? "" : ",") + seed_text(seed);
  line += " " + std::to_string(entry.draws) + " " + std::to_string(entry.evidence_sum.first()) + " " +
          std::to_string(entry.evidence_sum.channels().size());
  for (const auto& channel : entry.evidence_sum.channels()) {
    for (const EvidenceSum::Sum& sum : channel) {
      for (double x : {sum.total.above_reference, sum.total.below_reference, sum.total.below_upper_margin,
                       sum.total.above_lower_margin})
        put(line, x);
      if (run) continue;
      put(line, sum.below_upper_margin);
      put(line, sum.above_lower_margin);
    }
  }
  return line + " " + seed_text(hash_of(line)) + "\n";
}

std::optional<LedgerEntry> entry_of(std::string_view line) {
  constexpr std::size_t digits = 16;
  if (line.size() <= digits + 1) return {};
  const std::string_view body = line.substr(0, line.size() - digits - 1);
  if (line.substr(body.size()) != " " + seed_text(hash_of(body))) return {};
  Words words(body);
  const std::string_view kind = words.next();
  LedgerEntry entry;
  entry.claim = words.next();
  entry.content = words.number<std::uint64_t>(words.next(), 16);
  entry.seeds = seeds_of(words);
  entry.draws = words.number<std::uint64_t>(words.next());
  entry.evidence_sum = evidence_sum_of(words, kind == "run");
  if (!words.good() || (kind != "run" && kind != "sum") || entry.seeds.empty() || entry.evidence_sum.empty())
    return {};
  return entry;
}

}  // namespace fairlight
