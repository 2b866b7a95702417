// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Elements of an SVG document.

#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brachisto::report {

/// A place in a drawing, y down [px].
struct Pixel {
  double x, y;
};

/// Text as content or attribute value of XML and HTML. Characters that XML
/// does not have become U+FFFD.
[[nodiscard]] std::string xml_escaped(std::string_view text);

/// Collects the elements of a drawing. Attributes and markup are written as
/// they are given: what comes from elsewhere has to be escaped.
class Svg {
 public:
  void line(Pixel from, Pixel to, std::string_view attributes);
  void polyline(const std::vector<Pixel>& points, std::string_view attributes);
  void polygon(const std::vector<Pixel>& points, std::string_view attributes);
  void circle(Pixel centre, double radius, std::string_view attributes);
  void rectangle(Pixel corner, double width, double height,
                 std::string_view attributes);
  void text(Pixel at, std::string_view attributes, std::string_view markup);

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format,
                   std::forward<Args>(args)...);
  }

  /// The document, on white, with a title for those who cannot see it.
  /// \param top  where it begins; above zero there is room for more
  [[nodiscard]] std::string document(double width, double height,
                                     std::string_view title = {},
                                     double top = 0.0) const;

 private:
  void shape(std::string_view element, const std::vector<Pixel>& points,
             std::string_view attributes);

  std::string out_;
};

}  // namespace brachisto::report
