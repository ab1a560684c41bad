#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fairlight/stats/rosenblatt.h>
#include <fairlight/stats/same_law.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

constexpr std::uint64_t pilot_pairs = 4096;
constexpr double above_one = 2;  // an edge beyond all places

// Edges at quantiles of a sorted sample. A number that fills a quarter of a part has its own part.
std::vector<double> quantile_edges(const std::vector<double>& sorted, std::size_t parts) {
  std::vector<double> edges{0, above_one};
  const std::size_t many = std::max<std::size_t>(sorted.size() / (4 * parts), 2);
  for (std::size_t k = 1; k < parts; ++k) edges.push_back(sorted[k * sorted.size() / parts]);
  for (std::size_t i = 0; i + many <= sorted.size();) {
    const auto end = std::upper_bound(sorted.begin(), sorted.end(), sorted[i]);
    const auto after = static_cast<std::size_t>(end - sorted.begin());
    if (after - i >= many) {
      edges.push_back(sorted[i]);
      edges.push_back(std::nextafter(sorted[i], above_one));
    }
    i = after;
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::size_t part_of(const std::vector<double>& edges, double x) {
  return static_cast<std::size_t>(std::upper_bound(edges.begin() + 1, edges.end() - 1, x) - edges.begin()) - 1;
}

// The part and the position in it, as a fraction of all parts.
double rank_of(const std::vector<double>& edges, double x) {
  const std::size_t k = part_of(edges, x);
  const double low = edges[k], high = std::min(edges[k + 1], 1.0);
  const double within = high > low ? std::clamp((x - low) / (high - low), 0.0, 1.0) : 0.5;
  return (static_cast<double>(k) + within) / static_cast<double>(edges.size() - 1);
}

// The sign of the difference of the counts of earlier draws, in fine cells of the ranks.
class Witness {
 public:
  // In [-1,1]; 0 where the difference is within one standard deviation.
  double value(const Eigen::Vector2d& ranks) const {
    const Counts& cell = cells_[index(ranks)];
    const double difference = cell.a - cell.b;
    return difference * difference > cell.a + cell.b ? std::copysign(1, difference) : 0;
  }
  void count_a(const Eigen::Vector2d& ranks) { ++cells_[index(ranks)].a; }
  void count_b(const Eigen::Vector2d& ranks) { ++cells_[index(ranks)].b; }

 private:
  struct Counts {
    double a = 0, b = 0;
  };
  static constexpr int rows = 256, columns = 16;

  static std::size_t index(const Eigen::Vector2d& ranks) {
    const int row = std::min(static_cast<int>(ranks.x() * rows), rows - 1);
    return static_cast<std::size_t>(row * columns + std::min(static_cast<int>(ranks.y() * columns), columns - 1));
  }

  std::array<Counts, std::size_t{rows * columns}> cells_{};
};

// The differences of pairs of draws.
class Pairwise {
 public:
  Pairwise(PilotCells cells, bool line) : cells_(std::move(cells)), line_(line) {}

  std::size_t moments() const { return line_ ? 3 : 15; }
  std::size_t lost_cell() const { return cells_.size(); }
  std::size_t channels() const { return cells_.size() + 1 + moments() + 1; }

  void fill(const std::optional<Eigen::Vector2d>& a, const std::optional<Eigen::Vector2d>& b,
            std::vector<std::vector<double>>& out, std::size_t i) {
    for (auto& channel : out) channel[i] = 0;
    add(a, 1, out, i);
    add(b, -1, out, i);
    if (a) witness_.count_a(cells_.ranks(*a));
    if (b) witness_.count_b(cells_.ranks(*b));
  }

  std::size_t cell(const std::optional<Eigen::Vector2d>& place) const {
    return place ? cells_.index(*place) : lost_cell();
  }

 private:
  void add(const std::optional<Eigen::Vector2d>& place, double sign, std::vector<std::vector<double>>& out,
           std::size_t i) const {
    out[cell(place)][i] += sign;
    if (!place) return;
    const Eigen::Vector2d ranks = cells_.ranks(*place);
    const auto moment = cosine_moments(ranks, line_);
    for (std::size_t k = 0; k < moment.size(); ++k) out[lost_cell() + 1 + k][i] += sign * moment[k];
    out.back()[i] += sign * witness_.value(ranks);
  }

  PilotCells cells_;
  bool line_;
  Witness witness_;
};

// The place of a draw, in the unit square.
std::optional<Eigen::Vector2d> checked(std::uint64_t i, const std::optional<Eigen::Vector2d>& place) {
  if (place) check_place(i, *place);
  return place;
}

std::vector<Reference> references_of(const Pairwise& pairwise, const std::vector<double>& masses) {
  const auto difference = [](double reach, double scale) {
    return Reference{.mean = 0, .lower = -reach, .upper = reach, .scale = scale};
  };
  std::vector<Reference> references;
  constexpr double least = 1.0 / 64;  // a rarer cell has the margin of this one
  for (double mass : masses) references.push_back(difference(1.00001, std::sqrt(std::max(mass, least))));
  for (std::size_t k = 0; k < pairwise.moments(); ++k) references.push_back(difference(4.00001, 1));
  references.push_back(difference(2.00001, 1));
  return references;
}

}  // namespace

PilotCells::PilotCells(std::span<const Eigen::Vector2d> pilot, bool line) {
  if (pilot.empty()) throw std::invalid_argument("the pilot has no draws (all are lost)");
  const auto sorted = [](std::vector<double> x) {
    std::sort(x.begin(), x.end());
    return x;
  };
  std::vector<double> s;
  for (const auto& place : pilot) s.push_back(place.x());
  rows_ = quantile_edges(sorted(s), line ? 32 : 8);
  std::vector<std::vector<double>> t(rows_.size() - 1);
  for (const auto& place : pilot) t[part_of(rows_, place.x())].push_back(place.y());
  first_.push_back(0);
  for (const auto& row : t) {
    columns_.push_back(line || row.empty() ? std::vector<double>{0, above_one} : quantile_edges(sorted(row), 4));
    first_.push_back(first_.back() + columns_.back().size() - 1);
  }
}

std::size_t PilotCells::index(const Eigen::Vector2d& place) const {
  const std::size_t row = part_of(rows_, place.x());
  return first_[row] + part_of(columns_[row], place.y());
}

Eigen::Vector2d PilotCells::ranks(const Eigen::Vector2d& place) const {
  return {rank_of(rows_, place.x()), rank_of(columns_[part_of(rows_, place.x())], place.y())};
}

Finding test_same_law(const Trial& trial, const PlaceOfDraw& a, const PlaceOfDraw& b, bool line) {
  return detail::guarded(trial, [&] {
    std::vector<std::optional<Eigen::Vector2d>> pilot;
    std::vector<Eigen::Vector2d> places;
    for (std::uint64_t i = 0; i < pilot_pairs; ++i) {
      for (const PlaceOfDraw& draw : {a, b}) {
        pilot.push_back(checked(i, draw(i)));
        if (pilot.back()) places.push_back(*pilot.back());
      }
    }
    if (places.empty()) places.push_back(Eigen::Vector2d::Constant(0.5));  // both lose all draws, so far
    Pairwise pairwise(PilotCells(places, line), line);
    std::vector<double> masses(pairwise.lost_cell() + 1);
    for (const auto& place : pilot) masses[pairwise.cell(place)] += 1 / static_cast<double>(pilot.size());
    Finding finding = test_means(trial, references_of(pairwise, masses),
                                 [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
                                   for (std::size_t i = 0; i < channels[0].size(); ++i) {
                                     const std::uint64_t k = first + i + pilot_pairs;
                                     const auto of_a = checked(k, a(k)), of_b = checked(k, b(k));
                                     pairwise.fill(of_a, of_b, channels, i);
                                   }
                                 });
    if (finding.verdict == Verdict::certified)
      finding.note = formatted("shown of %zu cells and %zu cosine moments; not of what differs within cells",
                               masses.size() - 1, pairwise.moments());
    return finding;
  });
}

}  // namespace fairlight
