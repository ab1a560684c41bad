#include <algorithm>
#include <cmath>

#include <fairlight/stats/law_cells.h>
#include <fairlight/stats/quadrature.h>

namespace fairlight {
namespace {

constexpr int rows_of_line = 128, rows_of_square = 16, columns_of_square = 8;
constexpr double tolerance = 1e-7;        // of the mass in all cells; a law sums to 1 within 1e-6
constexpr double strip_tolerance = 1e-9;  // of the mass in a strip: noise to the integral over strips

// The edges k/n in [0,1] and those that the landmarks add.
std::vector<double> edges(int n, const std::vector<double>& more) {
  std::vector<double> all(more);
  for (int k = 0; k <= n; ++k) all.push_back(double(k) / n);
  std::sort(all.begin(), all.end());
  return all;
}

// Those of the sorted numbers that lie between two others, and these two.
std::vector<double> within(const std::vector<double>& numbers, double low, double high) {
  std::vector<double> inside{low};
  for (double x : numbers) {
    if (x > low && x < high) inside.push_back(x);
  }
  inside.push_back(high);
  return inside;
}

// The inner edges of n parts of equal length, of which those with more than 1.5 shares of the mass
// are divided again, into parts of about one share. All edges are ends of leaves.
std::vector<double> edges_by_mass(const std::vector<Leaf>& leaves, int n, double total) {
  std::vector<double> result;
  std::size_t i = 0;
  for (int k = 0; k < n; ++k) {
    const std::size_t first = i;
    const double end = double(k + 1) / n;
    double mass = 0;
    for (; i < leaves.size() && leaves[i].high <= end; ++i) mass += leaves[i].integral.value;
    const double shares = total > 0 ? mass / total * n : 0;
    const double parts = shares > 1.5 ? std::round(shares) : 1;
    double sum = 0, next = 1;
    for (std::size_t j = first; j + 1 < i; ++j) {
      sum += leaves[j].integral.value;
      if (sum < next * mass / parts) continue;
      result.push_back(leaves[j].high);
      next = std::floor(sum / mass * parts) + 1;
    }
    if (k + 1 < n) result.push_back(end);
  }
  return result;
}

// The mass of the leaves between the edges, in order.
void add_masses(std::vector<double>& masses, const std::vector<Leaf>& leaves, const std::vector<double>& inner) {
  std::size_t i = 0;
  for (std::size_t k = 0; k <= inner.size(); ++k) {
    double mass = 0;
    for (; i < leaves.size() && (k == inner.size() || leaves[i].high <= inner[k]); ++i)
      mass += leaves[i].integral.value;
    masses.push_back(mass);
  }
}

// Integrates over lines and adds the largest error of one line.
struct Strips {
  double largest_error = 0;

  double integral(const std::function<double(double)>& f, const std::vector<double>& at) {
    const Integral sum = sum_of(integrate_in_leaves(f, at, {strip_tolerance}));
    largest_error = std::max(largest_error, sum.error);
    return sum.value;
  }
};

LawCells cells_of_line(const SquareDensity& density, const Landmarks& landmarks) {
  const auto f = [&](double s) { return checked_density(density(s, 0.5), s, 0.5); };
  const auto leaves =
      integrate_in_leaves(f, edges(rows_of_line, landmarks.s), {tolerance, 0.25 / rows_of_line, 4096});
  const Integral total = sum_of(leaves);
  LawCells cells{0, 1, {}, total.error};
  cells.row_edges = edges_by_mass(leaves, rows_of_line, total.value);
  add_masses(cells.probabilities, leaves, cells.row_edges);
  cells.rows = static_cast<int>(cells.probabilities.size());
  cells.column_edges.resize(cells.probabilities.size());
  for (std::size_t k = 0; k < cells.probabilities.size(); ++k) cells.first_of_row.push_back(k);
  return cells;
}

}  // namespace

Landmarks with_pilot(Landmarks landmarks, std::span<const Eigen::Vector2d> pilot) {
  constexpr std::size_t parts = 16;
  const auto add = [&](std::vector<double>& to, int axis) {
    std::vector<double> x;
    for (const Eigen::Vector2d& place : pilot) x.push_back(place[axis]);
    std::sort(x.begin(), x.end());
    if (x.empty()) return;
    const auto add_inside = [&](double edge) {
      if (edge > 0 && edge < 1) to.push_back(edge);
    };
    for (std::size_t k = 1; k < parts; ++k) add_inside(x[k * x.size() / parts]);
    // The tails, in ever longer steps.
    for (double step = (x.back() - x.front()) / 4; step > 0 && step < 1; step *= 4) {
      add_inside(x.front() - step);
      add_inside(x.back() + step);
    }
    std::sort(to.begin(), to.end());
  };
  add(landmarks.s, 0);
  if (!landmarks.line) add(landmarks.t, 1);
  return landmarks;
}

std::size_t LawCells::index(const Eigen::Vector2d& place) const {
  for (double x : place) {
    if (!(x >= 0 && x <= 1))
      throw std::out_of_range("a place outside the unit square (check its coordinates first)");
  }
  const auto cut = [](double x, int n) {
    return static_cast<std::size_t>(std::min(static_cast<int>(x * n), n - 1));
  };
  if (first_of_row.empty())
    return cut(place.x(), rows) * static_cast<std::size_t>(columns) + cut(place.y(), columns);
  const auto among = [](const std::vector<double>& inner, double x) {
    return static_cast<std::size_t>(std::upper_bound(inner.begin(), inner.end(), x) - inner.begin());
  };
  const std::size_t row = among(row_edges, place.x());
  return first_of_row[row] + among(column_edges[row], place.y());
}

double checked_density(double value, double s, double t) {
  if (value >= 0 && std::isfinite(value)) return value;
  throw std::domain_error("the density is " + std::to_string(value) + " at (" + std::to_string(s) + ", " +
                          std::to_string(t) + ") of its domain's square (it must be nonnegative and finite)");
}

LawCells cells_of_square(const SquareDensity& density, const Landmarks& landmarks) {
  if (landmarks.line) return cells_of_line(density, landmarks);
  const auto f = [&](double s, double t) { return checked_density(density(s, t), s, t); };
  const std::vector<double> across = edges(columns_of_square, landmarks.t);
  Strips strips;
  const auto marginal = [&](double s) { return strips.integral([&](double t) { return f(s, t); }, across); };
  const auto slabs =
      integrate_in_leaves(marginal, edges(rows_of_square, landmarks.s), {tolerance, 0.25 / rows_of_square, 1024});
  LawCells cells{0, 1, {}, 0};
  cells.row_edges = edges_by_mass(slabs, rows_of_square, sum_of(slabs).value);
  // Within a row, a line along s is divided where its quarters of the mass end, and at the cuts.
  std::vector<double> starts = edges_by_mass(slabs, 4 * rows_of_square, sum_of(slabs).value);
  starts.insert(starts.end(), landmarks.s.begin(), landmarks.s.end());
  std::sort(starts.begin(), starts.end());
  const std::vector<double> rows = edges(1, cells.row_edges);
  cells.even_columns = true;
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    const std::vector<double> along = within(starts, rows[row], rows[row + 1]);
    const auto at_t = [&](double t) { return strips.integral([&](double s) { return f(s, t); }, along); };
    double mass = 0;
    for (const Leaf& slab : slabs)
      mass += slab.low >= rows[row] && slab.high <= rows[row + 1] ? slab.integral.value : 0;
    const auto leaves = integrate_in_leaves(
        at_t, across,
        {tolerance / static_cast<double>(rows.size()), std::max(0.25 * mass / columns_of_square, tolerance)});
    cells.first_of_row.push_back(cells.probabilities.size());
    cells.column_edges.push_back(edges_by_mass(leaves, columns_of_square, sum_of(leaves).value));
    add_masses(cells.probabilities, leaves, cells.column_edges.back());
    cells.error += sum_of(leaves).error;
    cells.even_columns = cells.even_columns && cells.column_edges.back().size() + 1 == columns_of_square;
  }
  cells.error += strips.largest_error * static_cast<double>(rows.size());
  if (cells.even_columns) {
    cells.columns = columns_of_square;
    cells.rows = static_cast<int>(rows.size()) - 1;
  } else {
    cells.rows = static_cast<int>(cells.probabilities.size());
  }
  return cells;
}

LawCells cells_of_numbers(std::int64_t n, const std::function<double(std::int64_t i)>& probability) {
  if (n < 2 || n > 1 << 20) throw std::invalid_argument("a discrete law must have 2 .. 2^20 outcomes");
  LawCells cells{static_cast<int>(n), 1, {}, 0};
  cells.each_alone = true;
  for (std::int64_t i = 0; i < n; ++i) cells.probabilities.push_back(checked_density(probability(i), double(i), 0));
  return cells;
}

LawCells with_lost(LawCells cells, double share) {
  if (share == 0) return cells;
  cells.probabilities.push_back(share);
  cells.lossy = true;
  return cells;
}

LawCells cells_of_table(const LawTable& table) {
  const auto cells = static_cast<std::int64_t>(table.probabilities.size());
  if (table.rows < 1 || table.columns < 1 || std::int64_t{table.rows} * table.columns != cells)
    throw std::invalid_argument("a table of a law must have rows x columns probabilities");
  LawCells result =
      cells_of_numbers(cells, [&](std::int64_t i) { return table.probabilities[static_cast<std::size_t>(i)]; });
  result.rows = table.rows;
  result.columns = table.columns;
  return result;
}

}  // namespace fairlight
