#include <algorithm>
#include <cmath>
#include <vector>

#include <fairlight/stats/law_test.h>
#include <fairlight/validation/report/axes.h>
#include <fairlight/validation/report/charts.h>

namespace fairlight {
namespace {

constexpr Colour black{0, 0, 0};
constexpr Colour grey{150, 150, 150};
constexpr Colour pale{190, 205, 225};
constexpr Colour red{200, 30, 30};
constexpr Colour blue{30, 80, 190};
constexpr Colour orange{235, 140, 20};
constexpr Colour green{20, 140, 70};

// Expected and counted draws of one bar.
struct Bar {
  double expected = 0;
  double counted = 0;
};

// The draws along an axis: cell i belongs to bar `place(i)` of n. Neighbours share a bar if n is
// above 128.
template <class Place>
std::vector<Bar> bars_along(const Evidence::Cells& cells, int n, const Place& place) {
  const std::size_t together = (static_cast<std::size_t>(n) + 127) / 128;
  std::vector<Bar> bars((static_cast<std::size_t>(n) + together - 1) / together);
  for (std::size_t i = 0; i < cells.counts.size(); ++i) {
    Bar& bar = bars[place(i) / together];
    bar.expected += cells.draws * cells.probabilities[i];
    bar.counted += static_cast<double>(cells.counts[i]);
  }
  return bars;
}

double largest(const std::vector<Bar>& bars) {
  double most = 1;
  for (const Bar& bar : bars) most = std::max({most, bar.expected, bar.counted});
  return most;
}

void draw_counts(Canvas& canvas, const Axes::Place& place, const std::vector<Bar>& bars, const std::string& axis) {
  const auto n = static_cast<double>(bars.size());
  const Axes axes(canvas, place, {0, n}, {0, 1.1 * largest(bars)});
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto at = static_cast<double>(i);
    canvas.rectangle(Axes::pixel(axes.x(at)), Axes::pixel(axes.y(bars[i].counted)), Axes::pixel(axes.x(at + 1)) - 1,
                     place.bottom, pale);
  }
  axes.draw("", "draws along " + axis);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto at = static_cast<double>(i);
    const double height = axes.y(bars[i].expected);
    canvas.line(axes.x(at), height, axes.x(at + 1) - 2, height, blue);
  }
}

// Draws the relative differences of counted and expected draws. A vertical line shows two standard
// deviations up and down.
void draw_differences(Canvas& canvas, const Axes::Place& place, const std::vector<Bar>& bars,
                      const std::string& axis) {
  double most = 1e-9;
  const auto difference = [](const Bar& bar) { return bar.expected > 0 ? bar.counted / bar.expected - 1 : 0; };
  const auto reach = [](const Bar& bar) { return bar.expected > 0 ? 2 / std::sqrt(bar.expected) : 0; };
  for (const Bar& bar : bars) {
    if (bar.expected >= 80) most = std::max(most, std::abs(difference(bar)) + reach(bar));
  }
  const auto n = static_cast<double>(bars.size());
  const Axes axes(canvas, place, {0, n}, {-1.1 * most, 1.1 * most});
  axes.draw("cell along " + axis, "counted / expected - 1");
  canvas.rectangle(place.left, Axes::pixel(axes.y(0)), place.right, Axes::pixel(axes.y(0)) + 2, blue);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (bars[i].expected < 80) continue;
    const double at = axes.x(static_cast<double>(i) + 0.5);
    const double value = difference(bars[i]);
    const Colour colour = std::abs(value) > 2 * reach(bars[i]) ? red : black;
    canvas.line(at, axes.y(value - reach(bars[i])), at, axes.y(value + reach(bars[i])), grey);
    canvas.rectangle(Axes::pixel(at) - 2, Axes::pixel(axes.y(value)) - 2, Axes::pixel(at) + 4,
                     Axes::pixel(axes.y(value)) + 4, colour);
  }
}

// White for a depth of 0; red (`more`) or blue for a depth of 1.
Colour shade(double depth, bool more) {
  const auto fade = [depth](int to) { return static_cast<std::uint8_t>(std::lround(255 + depth * (to - 255))); };
  const Colour& end = more ? red : blue;
  return {fade(end[0]), fade(end[1]), fade(end[2])};
}

// The full colour for p <= 1e-8.
Colour shade(const CellResidue& residue) {
  return shade(std::min(1.0, -std::log10(std::max(residue.p, 1e-300)) / 8), residue.deviations > 0);
}

struct Process {
  std::string name;
  double Wealth::*wealth;
  Colour colour;
};

// The processes that a claim uses: all four, or two for a one-sided claim.
std::vector<Process> processes_of(Sides sides) {
  std::vector<Process> processes;
  if (sides != Sides::not_below) processes.push_back({"above reference", &Wealth::above_reference, red});
  if (sides != Sides::not_above) processes.push_back({"below reference", &Wealth::below_reference, blue});
  if (sides != Sides::not_below)
    processes.push_back({"below reference + margin", &Wealth::below_upper_margin, orange});
  if (sides != Sides::not_above)
    processes.push_back({"above reference - margin", &Wealth::above_lower_margin, green});
  return processes;
}

double power(double logarithm) { return logarithm / std::log(10); }

void draw_process(Canvas& canvas, const Axes& axes, const Evidence::Course& course, const Process& process) {
  double from = 0;
  double height = 0;
  for (const auto& step : course.steps()) {
    const auto to = static_cast<double>(step.draws);
    const double risen = power(step.wealth.*process.wealth);
    canvas.line(axes.x(from), axes.y(height), axes.x(to), axes.y(risen), process.colour);
    from = to;
    height = risen;
  }
}

}  // namespace

CellResidue cell_residue(const Evidence::Cells& cells, std::size_t cell) {
  const double probability = cells.probabilities[cell];
  const double expected = cells.draws * probability;
  const double spread = std::sqrt(expected * (1 - probability));
  const double more = static_cast<double>(cells.counts[cell]) - expected;
  const CellTails tails = cell_tails(cells.counts[cell], cells.draws, probability);
  return {expected, spread > 0 ? more / spread : 0, std::min(1.0, 2 * std::min(tails.too_few, tails.too_many))};
}

Canvas histogram_chart(const std::string& title, const Evidence::Cells& cells) {
  const bool line = cells.columns == 1;
  Canvas canvas(line ? 900 : 1500, 700);
  canvas.text(20, 14, title);
  canvas.text(20, 40, "bars: counted; blue: expected; strokes: two standard deviations; red: more than four", grey);
  const auto columns = static_cast<std::size_t>(cells.columns);
  const auto panel = [&](int left, int right, const std::vector<Bar>& bars, const std::string& axis) {
    draw_counts(canvas, {left, 100, right, 340}, bars, axis);
    draw_differences(canvas, {left, 410, right, 640}, bars, axis);
  };
  panel(120, line ? 880 : 730, bars_along(cells, cells.rows, [=](std::size_t i) { return i / columns; }), "s");
  if (!line) panel(870, 1480, bars_along(cells, cells.columns, [=](std::size_t i) { return i % columns; }), "t");
  return canvas;
}

Canvas p_map_chart(const std::string& title, const Evidence::Cells& cells) {
  const int across =
      cells.columns == 1 ? std::min(cells.rows, 32) : cells.columns;  // a long row wraps into several
  const int down = (cells.rows * cells.columns + across - 1) / across;
  const int size = std::max(1, std::min({40, 1200 / across, 1200 / down}));
  Canvas canvas(std::max(760, across * size + 40), down * size + 140);
  canvas.text(20, 14, title);
  canvas.text(20, 40, "p of each cell, s downwards, t to the right", grey);
  for (int i = 0; i <= 80; ++i) {
    const int x = 20 + 4 * i;
    canvas.rectangle(x, 64, x + 4, 80, shade({1, 1, std::pow(10, -i / 10.0)}));
    canvas.rectangle(x + 360, 64, x + 364, 80, shade({1, -1, std::pow(10, -i / 10.0)}));
  }
  canvas.text(20, 86, "too many, p = 1", grey);
  canvas.text_to(344, 86, "1e-8", grey);
  canvas.text(380, 86, "too few, p = 1", grey);
  canvas.text_to(704, 86, "1e-8", grey);
  for (std::size_t i = 0; i < cells.counts.size(); ++i) {
    const int x = 20 + static_cast<int>(i) % across * size;
    const int y = 120 + static_cast<int>(i) / across * size;
    canvas.rectangle(x, y, x + size, y + size, {225, 225, 225});
    canvas.rectangle(x, y, x + std::max(1, size - 1), y + std::max(1, size - 1), shade(cell_residue(cells, i)));
  }
  return canvas;
}

Canvas tile_map_chart(const std::string& title, const Evidence::Tiles& tiles) {
  const int across = tiles.columns, size = std::max(1, 640 / across);
  const int down = static_cast<int>(tiles.biases.size()) / across;
  Canvas canvas(std::max(760, across * size + 40), down * size + 100);
  canvas.text(20, 14, title);
  canvas.text(20, 40, "red: too bright, blue: too dark; deep at twice the margin", grey);
  for (std::size_t i = 0; i < tiles.biases.size(); ++i) {
    const int x = 20 + static_cast<int>(i) % across * size;
    const int y = 80 + static_cast<int>(i) / across * size;
    const double depth = std::min(1.0, std::abs(tiles.biases[i]) / 2);
    canvas.rectangle(x, y, x + size, y + size, {225, 225, 225});
    canvas.rectangle(x, y, x + std::max(1, size - 1), y + std::max(1, size - 1), shade(depth, tiles.biases[i] > 0));
  }
  return canvas;
}

Canvas wealth_chart(const std::string& title, const Evidence::Course& course) {
  Canvas canvas(1100, 640);
  canvas.text(20, 14, title);
  const double last = course.steps().empty() ? 1 : static_cast<double>(course.steps().back().draws);
  const Axes::Place place{120, 110, 1080, 570};
  const Axes axes(canvas, place, {0, last}, {power(-course.refuting()), 1.15 * power(course.refuting())});
  axes.draw("draws", "wealth, as a power of ten");
  int x = 20;
  for (const Process& process : processes_of(course.sides())) {
    canvas.text(x, 42, process.name, process.colour);
    x += Canvas::letter_width * static_cast<int>(process.name.size() + 3);
    draw_process(canvas, axes, course, process);
  }
  const auto level = [&](double wealth, const std::string& says) {
    const int y = Axes::pixel(axes.y(power(wealth)));
    canvas.dashes(place.left, place.right, y, black);
    canvas.text(place.left + 10, y - 18, says);
  };
  level(course.refuting(), "biased: too bright or too dark is here");
  level(course.certifying(), "certified: not brighter and not darker are here");
  return canvas;
}

}  // namespace fairlight
