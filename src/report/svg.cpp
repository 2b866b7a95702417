// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/svg.hpp"

namespace brachisto::report {

std::string xml_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (code < 0x20 && c != '\t' && c != '\n' && c != '\r') {
      out += "\uFFFD";
    } else {
      out += c;
    }
  }
  return out;
}

void Svg::line(Pixel from, Pixel to, std::string_view attributes) {
  put("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n",
      from.x, from.y, to.x, to.y, attributes);
}

void Svg::shape(std::string_view element, const std::vector<Pixel>& points,
                std::string_view attributes) {
  put("<{} {} points=\"", element, attributes);
  for (const Pixel& p : points) put("{:.2f},{:.2f} ", p.x, p.y);
  out_ += "\"/>\n";
}

void Svg::polyline(const std::vector<Pixel>& points,
                   std::string_view attributes) {
  shape("polyline", points, attributes);
}

void Svg::polygon(const std::vector<Pixel>& points,
                  std::string_view attributes) {
  shape("polygon", points, attributes);
}

void Svg::circle(Pixel centre, double radius, std::string_view attributes) {
  put("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", centre.x,
      centre.y, radius, attributes);
}

void Svg::rectangle(Pixel corner, double width, double height,
                    std::string_view attributes) {
  put("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
      "{}/>\n",
      corner.x, corner.y, width, height, attributes);
}

void Svg::text(Pixel at, std::string_view attributes, std::string_view markup) {
  put("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x, at.y, attributes,
      markup);
}

std::string Svg::document(double width, double height, std::string_view title,
                          double top) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 {4:.0f} {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"14\">\n{2}"
      "<rect{5} width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "{3}</svg>\n",
      width, height - top,
      title.empty() ? ""
                    : fmt::format("<title>{}</title>\n", xml_escaped(title)),
      out_, top, top == 0.0 ? "" : fmt::format(" y=\"{:.0f}\"", top));
}

}  // namespace brachisto::report
