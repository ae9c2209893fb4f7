// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/DeviationReport.h"

#include "document/AtomicFile.h"
#include "report/BoundText.h"
#include "viewport/OffscreenPicture.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kReportWidth = 640, kHeight = 200;  // size of a histogram, in pixels at 96 an inch
constexpr char kBarColour[] = "#3465a4";
constexpr char kPicture[] = "sides";
constexpr int kSideWidth = 800, kSideHeight = 600;  // size of the picture from one side, in pixels
// The corners of a tetrahedron: each side of the model is seen from one of them.
const Vec3 kSides[] = {{1, -1, 1}, {-1, 1, 1}, {-1, -1, -1}, {1, 1, -1}};

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value == 0.0 ? 0.0 : value, std::chars_format::general, 6).ptr};
}

std::string point(const Vec3& p) {
  return number(p.x()) + ", " + number(p.y()) + ", " + number(p.z());
}

struct Row {
  std::string name, ofMesh, ofScan;
};

std::string extreme(const DeviationExtremum& extremum) {
  return number(extremum.distance) + " at " + point(extremum.position);
}

std::vector<Row> rowsOf(const Deviation& d) {
  const auto row = [&](std::string name, auto value) { return Row{std::move(name), value(d.ofMesh), value(d.ofScan)}; };
  std::vector<Row> rows;
  rows.push_back(row("Mean", [](const SurfaceDeviation& s) { return number(s.mean); }));
  rows.push_back(row("Mean, without sign", [](const SurfaceDeviation& s) { return number(s.meanAbsolute); }));
  rows.push_back(row("RMS", [](const SurfaceDeviation& s) { return number(s.rms); }));
  for (std::size_t i = 0; i < kDeviationPercentiles.size(); ++i) {
    rows.push_back(row(number(kDeviationPercentiles[i]) + " % of the area within",
                       [i](const SurfaceDeviation& s) { return number(s.percentiles[i]); }));
  }
  rows.push_back(row("Lowest", [](const SurfaceDeviation& s) { return extreme(s.lowest); }));
  rows.push_back(row("Highest", [](const SurfaceDeviation& s) { return extreme(s.highest); }));
  rows.push_back(row("Vertices", [](const SurfaceDeviation& s) { return std::to_string(s.vertices); }));
  rows.push_back(row("Samples", [](const SurfaceDeviation& s) { return std::to_string(s.samples); }));
  rows.push_back(row("Area (mm2)", [](const SurfaceDeviation& s) { return number(s.area); }));
  return rows;
}

std::string escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

double tallest(const SurfaceDeviation& s) {
  return *std::max_element(s.histogram.begin(), s.histogram.end());
}

std::string svgOf(const SurfaceDeviation& s) {
  const auto size = [](double value) { return number(value); };
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(kReportWidth) +
                    "\" height=\"" + std::to_string(kHeight + 20) + "\" role=\"img\">\n";
  const double bar = static_cast<double>(kReportWidth) / static_cast<double>(s.histogram.size());
  for (std::size_t i = 0; i < s.histogram.size(); ++i) {
    const double height = kHeight * s.histogram[i] / tallest(s);
    svg += "<rect x=\"" + size(bar * static_cast<double>(i)) + "\" y=\"" + size(kHeight - height) + "\" width=\"" +
           size(bar) + "\" height=\"" + size(height) + "\" fill=\"" + kBarColour + "\"/>\n";
  }
  const auto label = [&](const char* anchor, int x, double value) {
    svg += "<text x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(kHeight + 15) + "\" text-anchor=\"" + anchor +
           "\" font-size=\"12\">" + number(value) + " mm</text>\n";
  };
  svg += "<line x1=\"0\" y1=\"" + std::to_string(kHeight) + "\" x2=\"" + std::to_string(kReportWidth) + "\" y2=\"" +
         std::to_string(kHeight) + "\" stroke=\"black\"/>\n";
  label("start", 0, s.lowest.distance);
  label("end", kReportWidth, s.highest.distance);
  return svg + "</svg>\n";
}

QImage pictureOf(const SurfaceDeviation& s) {
  constexpr int kRatio = 3;  // sharp on paper
  QImage image(kReportWidth * kRatio, kHeight * kRatio, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.scale(kRatio, kRatio);
  const double bar = static_cast<double>(kReportWidth) / static_cast<double>(s.histogram.size());
  for (std::size_t i = 0; i < s.histogram.size(); ++i) {
    const double height = kHeight * s.histogram[i] / tallest(s);
    painter.fillRect(QRectF(bar * static_cast<double>(i), kHeight - height, bar, height), QColor(kBarColour));
  }
  painter.drawLine(0, kHeight - 1, kReportWidth, kHeight - 1);
  return image;
}

std::string boundText(const Comparison& c) {
  return c.deviation.atMost ? " No point is farther away than " + roundedUpText(*c.deviation.atMost) + " mm."
                            : std::string();
}

// The page without its frame; histogram(surface, name) draws one, picture is the element of the picture.
template <class Histogram>
std::string bodyOf(const Comparison& c, Histogram histogram, const std::string& picture) {
  std::string body = "<h1>Deviation</h1>\n<p>Mesh: " + escaped(c.mesh) + "<br/>Scan: " + escaped(c.scan) +
                     "</p>\n<p>Distances in mm, positive on the side of the normals of the other surface. "
                     "The largest distance found either way is " +
                     number(c.deviation.hausdorff()) + " mm." + boundText(c) + "</p>\n" +
                     "<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n"
                     "<tr><th></th><th>Mesh from scan</th><th>Scan from mesh</th></tr>\n";
  for (const Row& row : rowsOf(c.deviation)) {
    body += "<tr><td>" + row.name + "</td><td>" + row.ofMesh + "</td><td>" + row.ofScan + "</td></tr>\n";
  }
  body += "</table>\n" + (picture.empty() ? picture : "<h2>Mesh from scan</h2>\n<p>" + picture + "</p>\n") +
          "<h2>Mesh from scan, shares of the area</h2>\n" + histogram(c.deviation.ofMesh, "mesh") +
          "<h2>Scan from mesh, shares of the area</h2>\n" + histogram(c.deviation.ofScan, "scan");
  return body;
}

std::string base64Of(const QImage& picture) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return buffer.data().toBase64().toStdString();
}

Json toJson(const DeviationExtremum& extremum) {
  const auto coordinates = [](const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); };
  return {{"distance_mm", extremum.distance},
          {"at", coordinates(extremum.position)},
          {"nearest", coordinates(extremum.nearest)}};
}

Json toJson(const SurfaceDeviation& s) {
  Json percentiles = Json::object();
  for (std::size_t i = 0; i < kDeviationPercentiles.size(); ++i) {
    percentiles[number(kDeviationPercentiles[i])] = s.percentiles[i];
  }
  return {{"vertices", s.vertices},
          {"samples", s.samples},
          {"area_mm2", s.area},
          {"mean_mm", s.mean},
          {"mean_absolute_mm", s.meanAbsolute},
          {"rms_mm", s.rms},
          {"lowest", toJson(s.lowest)},
          {"highest", toJson(s.highest)},
          {"percentiles_mm", percentiles},
          {"histogram", s.histogram}};
}

}  // namespace

double defaultRange(const SurfaceDeviation& deviation) {
  constexpr double kSame = 1e-6;  // share of the surface's size: nearer is the rounding of a file
  const double same = std::max(kSame * std::sqrt(deviation.area), 1e-300);
  const double percentile = deviation.percentiles.back();
  if (percentile > same) return percentile;
  return std::max(std::abs(deviation.farthest().distance), same);
}

Result<QImage> deviationPicture(const HalfEdgeMesh& mesh, const VertexValues& atVertex, const ColourScale& scale,
                                Progress progress) {
  const Result<std::vector<QImage>> sides =
      renderSides(mesh, atVertex, scale, kSides, {kSideWidth, kSideHeight}, progress);
  if (!sides) return sides.error();
  QImage sheet(2 * kSideWidth, 2 * kSideHeight, QImage::Format_RGB32);
  if (sheet.isNull()) return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  QPainter painter(&sheet);
  for (int i = 0; i < 4; ++i) painter.drawImage(i % 2 * kSideWidth, i / 2 * kSideHeight, (*sides)[std::size_t(i)]);
  return sheet;
}

std::string readableText(const Comparison& c) {
  std::string text = "Distances in mm; positive on the side of the normals of the other surface.\n\n";
  std::vector<Row> rows = rowsOf(c.deviation);
  rows.insert(rows.begin(), {"", "Mesh from scan", "Scan from mesh"});
  std::size_t names = 0, values = 0;
  for (const Row& row : rows) {
    names = std::max(names, row.name.size());
    values = std::max(values, row.ofMesh.size());
  }
  for (const Row& row : rows) {
    text += row.name + std::string(names + 2 - row.name.size(), ' ') + row.ofMesh +
            std::string(values + 2 - row.ofMesh.size(), ' ') + row.ofScan + "\n";
  }
  return text + "\nLargest distance found either way: " + number(c.deviation.hausdorff()) + "\n" +
         (c.deviation.atMost ? "No point is farther away than: " + roundedUpText(*c.deviation.atMost) + "\n" : "");
}

Json toJson(const Comparison& c) {
  Json json = {{"mesh", c.mesh},
               {"scan", c.scan},
               {"largest_distance_mm", c.deviation.hausdorff()},
               {"mesh_from_scan", toJson(c.deviation.ofMesh)},
               {"scan_from_mesh", toJson(c.deviation.ofScan)}};
  if (c.deviation.atMost) json["no_distance_above_mm"] = *c.deviation.atMost;
  return json;
}

std::string htmlOf(const Comparison& c) {
  const auto histogram = [](const SurfaceDeviation& s, const char*) { return svgOf(s); };
  const std::string picture = c.picture.isNull() ? std::string()
                                                 : "<img style=\"width: 100%\" alt=\"The mesh in colours\" "
                                                   "src=\"data:image/png;base64," +
                                                       base64Of(c.picture) + "\"/>";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>Deviation of " + escaped(c.mesh) +
         "</title>\n<style>body { font-family: sans-serif; max-width: 60em; margin: 2em auto; }</style></head>\n"
         "<body>\n" +
         bodyOf(c, histogram, picture) + "</body>\n</html>\n";
}

std::string pdfOf(const Comparison& c) {
  QTextDocument document;
  const auto histogram = [&](const SurfaceDeviation& s, const char* name) {
    document.addResource(QTextDocument::ImageResource, QUrl(name), pictureOf(s));
    return "<p><img src=\"" + std::string(name) + "\" width=\"" + std::to_string(kReportWidth * 3 / 4) +
           "\"/><br/>from " + number(s.lowest.distance) + " to " + number(s.highest.distance) + " mm</p>\n";
  };
  std::string picture;
  if (!c.picture.isNull()) {
    document.addResource(QTextDocument::ImageResource, QUrl(kPicture), c.picture);
    picture = "<img src=\"" + std::string(kPicture) + "\" width=\"" + std::to_string(kReportWidth) + "\"/>";
  }
  document.setHtml(QString::fromStdString(bodyOf(c, histogram, picture)));
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setTitle(QString::fromStdString("Deviation of " + c.mesh));
  document.print(&writer);
  buffer.close();
  return buffer.data().toStdString();
}

Status writeReport(const Comparison& comparison, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  Comparison shared = comparison;
  for (std::string* const name : {&shared.mesh, &shared.scan}) *name = std::filesystem::path(*name).filename().string();
  if (ending == ".json")
    return writeFileAtomically(path, toJson(shared).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  return writeFileAtomically(path, ending == ".pdf" ? pdfOf(shared) : htmlOf(shared));
}

}  // namespace handwheel
