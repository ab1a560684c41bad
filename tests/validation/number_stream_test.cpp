#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/run/law_file.h>
#include <fairlight/validation/run/number_stream.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// All rows, or the message of the error.
std::vector<std::vector<double>> rows_of(const std::string& text, NumberFormat format = NumberFormat::text,
                                         std::size_t columns = 0) {
  std::istringstream in(text);
  NumberStream stream(in, format, columns);
  std::vector<std::vector<double>> channels(stream.columns(), std::vector<double>(100));
  const std::size_t n = stream.read(channels);
  for (auto& channel : channels) channel.resize(n);
  return channels;
}

std::string problem(const std::string& text, NumberFormat format = NumberFormat::text, std::size_t columns = 0) {
  try {
    rows_of(text, format, columns);
    return "";
  } catch (const BadInput& bad) {
    return bad.what();
  }
}

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers) {
  return std::string(reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(Number));
}

TEST(NumberStream, ReadsOneNumberALine) {
  EXPECT_THAT(rows_of("0.5\n1e-3\n+2\n-.5"), ElementsAre(ElementsAre(0.5, 1e-3, 2, -0.5)));
}

TEST(NumberStream, SkipsBlankLinesCommentsAndCarriageReturns) {
  EXPECT_THAT(rows_of("# draws\r\n\r\n1\r\n  \n2 # two\r\n"), ElementsAre(ElementsAre(1, 2)));
}

TEST(NumberStream, ReadsColumnsWithAnySeparator) {
  EXPECT_THAT(rows_of("1 2\n3,4\n5;\t6\n"), ElementsAre(ElementsAre(1, 3, 5), ElementsAre(2, 4, 6)));
}

TEST(NumberStream, PassesOnWhatIsNoFiniteNumber) {
  const auto rows = rows_of("nan\ninf\n-inf\n");
  EXPECT_TRUE(std::isnan(rows[0][0]));
  EXPECT_TRUE(std::isinf(rows[0][1]) && std::isinf(rows[0][2]));
}

TEST(NumberStream, ReadsBinaryRows) {
  EXPECT_THAT(rows_of(bytes_of<double>({1, 2}), NumberFormat::f64), ElementsAre(ElementsAre(1, 2)));
  EXPECT_THAT(rows_of(bytes_of<float>({1, 2, 3, 4}), NumberFormat::f32, 2),
              ElementsAre(ElementsAre(1, 3), ElementsAre(2, 4)));
  EXPECT_THAT(rows_of(bytes_of<double>({1, 2, 3, 4}), NumberFormat::f64, 2),
              ElementsAre(ElementsAre(1, 3), ElementsAre(2, 4)));
}

TEST(NumberStream, NamesTheLineOfBadText) {
  EXPECT_THAT(problem(""), HasSubstr("no numbers"));
  EXPECT_THAT(problem("# nothing\n\n"), HasSubstr("no numbers"));
  EXPECT_THAT(problem("1\n\nabc\n"), HasSubstr("line 3 of standard input holds \"abc\""));
  EXPECT_THAT(problem("1\n2x\n"), HasSubstr("\"2x\""));
  EXPECT_THAT(problem("1\n+-2\n"), HasSubstr("\"+-2\""));
  EXPECT_THAT(problem("1e999\n"), HasSubstr("cannot hold"));
  EXPECT_THAT(problem("1 2\n3\n"), HasSubstr("line 2 of standard input has 1 columns where 2"));
  EXPECT_THAT(problem("1\n2,5\n"), HasSubstr("a decimal sign is a point"));
  EXPECT_THAT(problem(std::string(1 << 17, '1')), HasSubstr("longer"));
}

TEST(NumberStream, NamesThePlaceOfTruncatedBinary) {
  EXPECT_THAT(problem("", NumberFormat::f64), HasSubstr("no numbers"));
  EXPECT_THAT(problem(bytes_of<double>({1}) + "abc", NumberFormat::f64), HasSubstr("ends 3 bytes into row 1"));
  EXPECT_THAT(problem(bytes_of<float>({1, 2, 3}), NumberFormat::f32, 2), HasSubstr("ends 4 bytes into row 1"));
}

IntervalLaw law_of(const std::string& text) {
  std::istringstream in(text);
  return read_law(in, "law.csv");
}

TEST(LawFile, ReadsCellsAndDensities) {
  EXPECT_THAT(law_of("0,1,0.25\n1,3,0.75\n").edges, ElementsAre(0, 1, 3));
  EXPECT_THAT(law_of("0,1,0.25\n1,3,0.75\n").probabilities, ElementsAre(0.25, 0.75));
  EXPECT_THAT(law_of("0,0\n0.5,1\n1,2\n").probabilities, ElementsAre(0.125 * 2, 0.375 * 2));
}

TEST(LawFile, RefusesWhatIsNoLaw) {
  for (const char* text : {"", "1\n2\n", "0,1,0.5\n1,2,0.6\n", "0,1,0.5\n1.5,2,0.5\n", "0,1,1.5\n1,2,-0.5\n",
                           "1,0,0.5\n0,2,0.5\n", "0,1,nan\n1,2,0.5\n", "0,1,1\n", "0,-1\n1,1\n2,1\n"})
    EXPECT_THROW(law_of(text), BadInput) << text;
}

}  // namespace
}  // namespace fairlight
