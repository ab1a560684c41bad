#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <regex>
#include <stdexcept>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/report/charts.h>
#include <fairlight/validation/run/subprocess.h>

namespace fairlight {

std::string chart_head(const std::string& title, int width, int height, const char* layout) {
  return formatted("set terminal pngcairo noenhanced size %d,%d font 'sans,11'\n", width, height) +
         formatted("set multiplot layout %s columnsfirst title '%s' font ',13'\n", layout,
                   std::regex_replace(title, std::regex("'"), "''").c_str()) +
         R"(red = '#c81e1e'; blue = '#1e50be'; orange = '#eb8c14'; green = '#148c46'; grey = '#808080'
set key outside top center horizontal
)";
}

namespace {

// The draws along one axis of the cells, as bars: cell i belongs to row `place(i)` of n. Neighbours
// share a bar if n is above 128. Differences with a standard deviation above 10 % are left out.
template <class Place>
std::string bars_along(const Evidence::Cells& cells, int n, const char* axis, const Place& place) {
  const auto width = (static_cast<std::size_t>(n) + 127) / 128;
  std::vector<double> counted((static_cast<std::size_t>(n) + width - 1) / width), expected(counted.size());
  for (std::size_t i = 0; i < cells.counts.size(); ++i) {
    counted[place(i) / width] += static_cast<double>(cells.counts[i]);
    expected[place(i) / width] += cells.draws * cells.probabilities[i];
  }
  std::string script = formatted("n = %d; width = %zu\n$bars << EOD\n", n, width);
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const double middle = (static_cast<double>(i) + 0.5) * static_cast<double>(width), percent = 100 / expected[i];
    const double deviation = percent * std::sqrt(expected[i] * std::max(0.0, 1 - expected[i] / cells.draws));
    script += formatted("%g %.0f %.10g %.5g %.5g\n", middle, counted[i], expected[i],
                        percent * (counted[i] - expected[i]), deviation);
  }
  return script + "EOD\nset xlabel '" + axis + R"('
set lmargin 12; set xrange [0:n]; set yrange [0:*]; set ylabel 'draws'; set boxwidth width
off(difference, deviation, least) = deviation < 10 && abs(difference) >= least * deviation ? difference : NaN
plot $bars using 1:2 with boxes fs solid noborder lc rgb '#bed0e8' title 'counted', \
  '' using 1:3 with histeps lw 1.5 lc rgb blue title 'expected'
set yrange [*:*]; set ylabel 'counted / expected - 1, in %'
plot 0 lw 1.5 lc rgb blue notitle, $bars using 1:(off($4, $5, 0)):(2 * $5) \
  with yerrorbars pt 7 ps 0.5 lc rgb grey title 'difference (bars: 2 standard deviations; none above 20 %)', \
  '' using 1:(off($4, $5, 4)):(2 * $5) \
  with yerrorbars pt 7 ps 0.5 lc rgb red title 'off by more than 4 standard deviations'
)";
}

// Shows each value at its place: white for 0, red for `most` and above, blue for -most and below.
std::string map(const std::vector<double>& values, int across, int most) {
  const int down = (static_cast<int>(values.size()) + across - 1) / across;
  std::string script = formatted("across = %d; down = %d; most = %d\n$cells << EOD\n", across, down, most);
  for (const double value : values) script += formatted("%.5g\n", value);
  return script + R"(EOD
set xrange [0:across]; set yrange [down:0]; set cbrange [-most:most]; set size ratio -1
set xtics 0,(across + 7) / 8 out nomirror; set ytics 0,(down + 7) / 8 out nomirror
set palette defined (-1 blue, 0 'white', 1 red)
plot $cells using (int($0) % across + 0.5):(int($0) / across + 0.5):(0.5):(0.5):1 \
  with boxxyerror fs solid noborder lc palette notitle
)";
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

std::string histogram_script(const std::string& title, const Evidence::Cells& cells) {
  const auto columns = static_cast<std::size_t>(cells.columns);
  const bool line = columns == 1;
  return chart_head(title + " (draws)", line ? 900 : 1500, 800, line ? "2,1" : "2,2") +
         bars_along(cells, cells.rows, line ? "cell" : "cell along s", [=](std::size_t i) { return i / columns; }) +
         (line ? "" : bars_along(cells, cells.columns, "cell along t", [=](std::size_t i) { return i % columns; }));
}

std::string p_map_script(const std::string& title, const Evidence::Cells& cells) {
  std::vector<double> powers;
  for (std::size_t i = 0; i < cells.counts.size(); ++i) {
    const CellResidue residue = cell_residue(cells, i);
    powers.push_back(std::copysign(std::log10(std::max(residue.p, 1e-300)), residue.deviations));
  }
  const auto side = std::bit_ceil(static_cast<unsigned>(std::ceil(std::sqrt(cells.rows))));
  const int across = cells.columns > 1 ? cells.columns : static_cast<int>(side);  // a column wraps
  return chart_head(title + " (p-values)", 900) +
         (cells.columns > 1 ? "set xlabel 'cell along t'; set ylabel 'cell along s'\n"
                            : formatted("set xlabel 'cells from the top left, %d in each row'\n", across)) +
         R"(set cblabel "p-value of each cell\nred: more draws than expected, blue: fewer" offset 1
set cbtics ('1e-8' -8, '1e-6' -6, '1e-4' -4, '1e-2' -2, '1' 0, '1e-2' 2, '1e-4' 4, '1e-6' 6, '1e-8' 8)
)" + map(powers, across, 8);
}

std::string tile_map_script(const std::string& title, const Evidence::Tiles& tiles) {
  return chart_head(title + " (bias of each tile)", 900) +
         R"(set xlabel 'column of tiles'; set ylabel 'row of tiles'
set cblabel "bias / margin\nred: above the reference, blue: below" offset 1
)" + map(tiles.biases, tiles.columns, 2);
}

std::string wealth_script(const std::string& title, const Evidence::Course& course) {
  std::string script = chart_head(title + " (wealth)", 1100) + "$steps << EOD\n0 0 0 0 0\n";
  const auto power = [](double logarithm) { return logarithm / std::log(10); };
  for (const auto& [draws, mean, w] : course.steps())
    script += std::to_string(draws) + formatted(" %.6g %.6g %.6g %.6g\n", power(w.above_reference),
                                                power(w.below_upper_margin), power(w.below_reference),
                                                power(w.above_lower_margin));
  return script + formatted(R"(EOD
biased = %g; certified = %g; first = %d; last = %d
set xlabel 'draws'; set ylabel 'log10 of the wealth; each bet starts with a wealth of 1'
set yrange [-biased:1.1 * biased]; set link y2; set autoscale xfix; set ytics nomirror
set y2tics ("biased:\nred or blue\nis here" biased, "certified:\norange and\ngreen are\nhere" certified)
bets = "'above the reference' 'below reference + margin' 'below the reference' 'above reference - margin'"
colours = red.' '.orange.' '.blue.' '.green; set key title 'bets that the mean is'
plot biased lc rgb 'black' dt 2 notitle, certified lc rgb 'black' dt 2 notitle, for [bet = first:last] \
  $steps using 1:(column(bet + 1)) with lines lw 2 lc rgb word(colours, bet) title word(bets, bet)
)",
                            power(course.refuting()), power(course.certifying()),
                            course.sides() == Sides::not_below ? 3 : 1, course.sides() == Sides::not_above ? 2 : 4);
}

std::string intervals_script(const std::vector<Outcome>& outcomes) {
  std::string script =
      chart_head("the bias of each claim lies in its interval", 1200, outcomes.size() > 40 ? 1400 : 700) +
      "$intervals << EOD\n";
  for (const Outcome& outcome : outcomes) {
    const Finding& finding = outcome.finding;
    const auto in_margins = [&](double end) { return std::clamp(end / finding.margin, -2.0, 2.0); };
    script += formatted("%s %s %.5g %.5g\n", outcome.claim->name.c_str(), name(finding.verdict),
                        in_margins(finding.interval.lo), in_margins(finding.interval.hi));
  }
  return script + R"(EOD
set yrange [|$intervals|:-1]; set xrange [-2:2]; set xlabel 'bias / margin (intervals beyond 2 end there)'
if (|$intervals| > 40) { set ylabel 'claims' } else {
  set ytics (); do for [i = 1:|$intervals|] { set ytics add (word($intervals[i], 1) i - 1) } }
set arrow from -1,graph 0 to -1,graph 1 nohead dt 2; set arrow from 1,graph 0 to 1,graph 1 nohead dt 2
set arrow from 0,graph 0 to 0,graph 1 nohead lc rgb grey
mark(low, high) = high - low < 0.04 ? 0.02 : 0  # makes what is short, or beyond the chart, visible
plot for [v in 'certified undecided biased'] \
  $intervals using (strcol(2) eq v ? $3 - mark($3, $4) : NaN):0:($4 - $3 + 2 * mark($3, $4)):(0) \
  with vectors nohead lw 2 lc rgb (v eq 'certified' ? green : v eq 'biased' ? red : orange) title v, \
  NaN dt 2 lc rgb 'black' title 'margin'
)";
}

void check_gnuplot() {
  try {
    if (run_process({"gnuplot", "-d", "-e", "set terminal pngcairo"}).status == 0) return;
  } catch (const std::runtime_error&) {  // says less
  }
  throw std::runtime_error(
      "charts need gnuplot with pngcairo, which is not on the PATH (install the Debian package gnuplot-nox)");
}

std::string write_chart(const std::string& stem, const std::string& script) {
  const std::string file = std::filesystem::absolute(stem + ".gp").string();  // begins with no hyphen
  write_whole(file, script);
  const auto [status, png, error] = run_process({"gnuplot", "-d", file});
  if (status != 0) {
    const std::string said = error.substr(0, error.find_last_not_of('\n') + 1);
    const std::string problem = said.substr(said.rfind('\n') + 1);
    throw std::runtime_error(formatted("gnuplot cannot draw \"%s.png\" (%s)", stem.c_str(), problem.c_str()));
  }
  write_whole(stem + ".png", png);
  return stem + ".png";
}

}  // namespace fairlight
