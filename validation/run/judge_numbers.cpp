#include <algorithm>
#include <cmath>

#include <fairlight/stats/law_test.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/run/judge_numbers.h>

namespace fairlight {
namespace {

constexpr std::uint64_t pilot_rows = 4096;

void require_columns(const NumberStream& stream, std::size_t columns, const char* test) {
  if (stream.columns() != columns)
    throw BadInput(formatted("the input has %zu columns where %s takes %zu", stream.columns(), test, columns));
}

constexpr Interval finite{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};

void require_in_range(std::uint64_t first, const std::vector<std::vector<double>>& rows, const Interval& range) {
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    for (const auto& column : rows) {
      const double x = column[i];
      if (!std::isfinite(x)) throw BadDraw(first + i, x, "not a finite number");
      if (!(x >= range.lo && x <= range.hi)) throw BadDraw(first + i, x, "outside its declared range");
    }
  }
}

// Fills all rows of the channels. Throws NoMoreDraws if the input ends, or the cap is reached. The
// last rows, too few for a block, count in no test; `check(first, rows)` finds bad draws in them.
template <class Check>
void fill(const Numbers& numbers, std::vector<std::vector<double>>& channels, const Check& check) {
  const std::uint64_t before = numbers.stream.rows();
  const std::size_t wanted = channels[0].size();
  if (wanted > numbers.most - std::min(numbers.most, before))
    throw NoMoreDraws(
        formatted("the largest number of draws, %llu, came first", static_cast<unsigned long long>(numbers.most)));
  const std::size_t read = numbers.stream.read(channels);
  if (read == wanted) return;
  for (auto& channel : channels) channel.resize(read);
  check(before, channels);
  throw NoMoreDraws(
      formatted("the input ended after %llu draws, before the verdict (draw more, or ask for a "
                "larger margin)",
                static_cast<unsigned long long>(numbers.stream.rows())));
}

// Checks rows against a range, for `fill`.
auto within(const Interval& range) {
  return [range](std::uint64_t first, const std::vector<std::vector<double>>& rows) {
    require_in_range(first, rows, range);
  };
}

// A source of draws for the tests. To report the size of a bias, test_each_mean asks again for the
// first draws once it has met a bad one: they are kept, as a pipe does not go back.
class Draws {
 public:
  Draws(std::size_t channels, std::function<void(std::vector<std::vector<double>>&)> next)
      : first_(channels), next_(std::move(next)) {}

  void operator()(std::uint64_t first, std::vector<std::vector<double>>& channels) {
    if (first < drawn_) return repeat(channels);
    next_(channels);
    drawn_ += channels[0].size();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const std::size_t more = std::min<std::size_t>(pilot_rows - first_[c].size(), channels[c].size());
      first_[c].insert(first_[c].end(), channels[c].begin(),
                       channels[c].begin() + static_cast<std::ptrdiff_t>(more));
    }
  }

 private:
  void repeat(std::vector<std::vector<double>>& channels) const {
    for (std::size_t c = 0; c < channels.size(); ++c) std::ranges::copy(first_[c], channels[c].begin());
    if (first_[0].size() < channels[0].size())
      throw BadDraw(first_[0].size(), std::numeric_limits<double>::quiet_NaN(), "not read");
  }

  std::vector<std::vector<double>> first_;
  std::function<void(std::vector<std::vector<double>>&)> next_;
  std::uint64_t drawn_ = 0;
};

// Student's and Welch's tests have no verdict of their own for draws that run out.
template <class Test>
Finding until_spent(const Trial& trial, const NumberStream& stream, const Test& test) {
  try {
    return test();
  } catch (const NoMoreDraws& spent) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Finding finding{Verdict::undecided, Guarantee::asymptotic, trial.margin};
    finding.interval = {-infinite, infinite};
    finding.draws = stream.rows();
    finding.note = spent.what();
    return finding;
  }
}

Finding refuted(const Trial& trial, const BadDraw& bad) {
  Finding finding{Verdict::biased, Guarantee::exact, trial.margin};
  finding.draws = bad.draw() + 1;
  finding.note = bad.what();
  return finding;
}

// The absolute mean of the second column of rows that no test uses.
double pilot_scale(const std::function<void(std::vector<std::vector<double>>&)>& next) {
  std::vector<std::vector<double>> pilot(2, std::vector<double>(pilot_rows));
  next(pilot);
  require_in_range(0, pilot, finite);
  const double mean = std::abs(Moments::of(pilot[1]).mean());
  if (!(mean > 0)) throw std::invalid_argument("the second column has the mean 0 at first (give --scale)");
  return mean;
}

// Pairs are checked here, as the difference of two numbers out of range may lie in the range of
// differences.
Finding judge_differences(const Trial& trial, const std::function<void(std::vector<std::vector<double>>&)>& next,
                          double scale, const Interval& range) {
  std::vector<std::vector<double>> pairs(2);
  std::uint64_t row = 0;
  Draws draws(1, [&](std::vector<std::vector<double>>& difference) {
    for (auto& column : pairs) column.resize(difference[0].size());
    next(pairs);
    require_in_range(row, pairs, range);
    row += pairs[0].size();
    std::ranges::transform(pairs[0], pairs[1], difference[0].begin(), std::minus<>());
  });
  const double width = range.hi - range.lo;
  return test_means(trial, {{0, -width, width, 0, scale}}, std::ref(draws));
}

// Counts rows in cells. Throws BadDraw for what `cell` rejects.
template <class Cell>
Finding judge_cells(const Trial& trial, const Numbers& numbers, const LawCells& cells, const Cell& cell) {
  std::vector<std::vector<double>> rows(numbers.stream.columns());
  std::uint64_t row = 0;
  Finding finding = test_counts(trial, cells, [&](std::uint64_t draws) {
    constexpr std::uint64_t block = 65536;
    std::vector<std::uint64_t> counts(cells.probabilities.size());
    for (std::uint64_t left = draws; left > 0;) {
      for (auto& column : rows) column.resize(std::min(left, block));
      fill(numbers, rows, [&](std::uint64_t first, const auto& last) {
        for (std::size_t i = 0; i < last[0].size(); ++i) cell(last, i, first + i);
      });
      for (std::size_t i = 0; i < rows[0].size(); ++i) ++counts[cell(rows, i, row++)];
      left -= rows[0].size();
    }
    return counts;
  });
  if (finding.draws == 0) finding.draws = row;
  return finding;
}

}  // namespace

Finding judge_mean(const Trial& trial, Numbers numbers, double mean, double scale, std::optional<Interval> range) {
  Draws draws(numbers.stream.columns(),
              [&](auto& channels) { fill(numbers, channels, within(range.value_or(finite))); });
  if (range) {
    const std::vector<Reference> references(numbers.stream.columns(), {mean, range->lo, range->hi, 0, scale});
    return test_means(trial, references, std::ref(draws));
  }
  require_columns(numbers.stream, 1, "a mean without a range");
  return until_spent(trial, numbers.stream, [&] { return sequential_t_test(trial, mean, scale, std::ref(draws)); });
}

Finding judge_agreement(const Trial& trial, Numbers numbers, NumberStream* other, std::optional<double> scale,
                        std::optional<Interval> range) try {
  require_columns(numbers.stream, other == nullptr ? 2 : 1, "an agreement");
  if (other != nullptr) require_columns(*other, 1, "an agreement of two inputs");
  const auto check = within(range.value_or(finite));
  const auto next = [&](std::vector<std::vector<double>>& pairs) {
    if (other == nullptr) return fill(numbers, pairs, check);
    for (std::size_t c = 0; c < 2; ++c) {
      std::vector<std::vector<double>> one{std::move(pairs[c])};
      fill({c == 0 ? numbers.stream : *other, numbers.most}, one, check);
      pairs[c] = std::move(one[0]);
    }
  };
  return until_spent(trial, numbers.stream, [&] {
    const double unit = scale ? *scale : pilot_scale(next);
    if (range) return judge_differences(trial, next, unit, *range);
    return sequential_welch_test(trial, unit, [&](std::uint64_t, auto& pairs) { next(pairs); });
  });
} catch (const BadDraw& bad) {
  return refuted(trial, bad);
}

Finding judge_law(const Trial& trial, Numbers numbers, const IntervalLaw& law) {
  require_columns(numbers.stream, 1, "a law of intervals");
  const LawCells cells{static_cast<int>(law.probabilities.size()), 1, law.probabilities, 0};
  return judge_cells(trial, numbers, cells, [&](const auto& rows, std::size_t i, std::uint64_t row) {
    const double x = rows[0][i];
    if (!(x >= law.edges.front() && x <= law.edges.back())) throw BadDraw(row, x, "outside the cells of the law");
    if (x == law.edges.back()) return law.probabilities.size() - 1;
    return static_cast<std::size_t>(std::ranges::upper_bound(law.edges, x) - law.edges.begin()) - 1;
  });
}

Finding judge_uniform(const Trial& trial, Numbers numbers) {
  const std::size_t dimensions = numbers.stream.columns();
  if (dimensions > 16)
    throw BadInput(formatted("the input has %zu columns where uniform points take at most 16", dimensions));
  // About 128 cells, as test_law has, but at least two along each axis.
  const double fine = std::floor(std::pow(128.0, 1 / static_cast<double>(dimensions)) + 1e-9);
  const auto along = static_cast<std::size_t>(std::max(2.0, fine));
  std::size_t all = 1;
  for (std::size_t d = 0; d < dimensions; ++d) all *= along;
  const LawCells cells{static_cast<int>(all), 1, std::vector<double>(all, 1 / static_cast<double>(all)), 0};
  return judge_cells(trial, numbers, cells, [&](const auto& rows, std::size_t i, std::uint64_t row) {
    std::size_t cell = 0;
    for (const auto& column : rows) {
      if (!(column[i] >= 0 && column[i] < 1)) throw BadDraw(row, column[i], "outside [0,1)");
      cell = cell * along + static_cast<std::size_t>(column[i] * static_cast<double>(along));
    }
    return cell;
  });
}

}  // namespace fairlight
