// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/PlotExport.h"

#include "document/AtomicFile.h"
#include "document/DocumentErrors.h"
#include "plot/PlotPainting.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QPainter>
#include <QSvgGenerator>
#include <charconv>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kPictureRatio = 2.0;  // scale of PNG files, so that they are sharp on paper and on dense screens
constexpr int kDotsPerInch = 96;  // density of one pixel before the ratio: the font has the same size in all formats

int columnsFor(std::size_t plots) {
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(plots))));
}

QSize gridSize(std::size_t plots, const QSize& size) {
  const int n = static_cast<int>(plots), columns = std::max(columnsFor(plots), 1);
  return {columns * size.width(), std::max((n + columns - 1) / columns, 1) * size.height()};
}

void paintGrid(QPainter& painter, std::span<const Plot> plots, const QSize& size, ThemeKind theme) {
  const QSize whole = gridSize(plots.size(), size);
  painter.fillRect(QRect(QPoint(), whole), themeColours(theme).window);
  QFont font = painter.font();
  font.setPixelSize(13);
  painter.setFont(font);
  const int columns = columnsFor(plots.size());
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    paintPlot(painter, QRectF(QPointF(column * size.width(), row * size.height()), size), plots[i], theme);
  }
}

QByteArray pngOf(std::span<const Plot> plots, const QSize& size, ThemeKind theme) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  plotImage(plots, size, theme, kPictureRatio).save(&buffer, "PNG");
  return buffer.data();
}

QByteArray svgOf(std::span<const Plot> plots, const QSize& size, ThemeKind theme) {
  QBuffer buffer;
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setResolution(kDotsPerInch);
  svg.setSize(gridSize(plots.size(), size));
  svg.setViewBox(QRect(QPoint(), svg.size()));
  QPainter painter(&svg);
  paintGrid(painter, plots, size, theme);
  painter.end();
  return buffer.data();
}

QByteArray number(double value) {
  char text[32];
  return {text, static_cast<qsizetype>(std::to_chars(text, text + sizeof text, value).ptr - text)};
}

// Quotes a field according to RFC 4180.
QByteArray field(QString text) {
  if (!text.contains(QLatin1Char(',')) && !text.contains(QLatin1Char('"')) && !text.contains(QLatin1Char('\n'))) {
    return text.toUtf8();
  }
  return '"' + text.replace(QLatin1String("\""), QLatin1String("\"\"")).toUtf8() + '"';
}

Status writeWhole(const QString& path, const QByteArray& bytes) {
  return writeFileAtomically(QFile::encodeName(path).toStdString(),
                             {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace

QImage plotImage(std::span<const Plot> plots, const QSize& size, ThemeKind theme, double pixelRatio) {
  QImage image((QSizeF(gridSize(plots.size(), size)) * pixelRatio).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(pixelRatio);
  image.setDotsPerMeterX(static_cast<int>(kDotsPerInch * pixelRatio / 0.0254));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  QPainter painter(&image);
  paintGrid(painter, plots, size, theme);
  return image;
}

Status exportPlots(std::span<const Plot> plots, const QString& path, const QSize& size, ThemeKind theme) {
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending == QLatin1String("png")) return writeWhole(path, pngOf(plots, size, theme));
  if (ending == QLatin1String("svg")) return writeWhole(path, svgOf(plots, size, theme));
  if (ending == QLatin1String("csv")) return writeWhole(path, plotCsv(plots));
  return Error{DocumentError::ExtensionUnknown,
               {"." + ending.toStdString(), ".png", ".svg", ".csv"},
               {},
               QFile::encodeName(path).toStdString()};
}

QByteArray plotCsv(std::span<const Plot> plots) {
  QByteArray csv = "plot,series,x,y\n";
  for (const Plot& plot : plots) {
    for (const PlotSeries& series : plot.series) {
      for (const QPointF& p : series.points) {
        csv += field(plot.title) + ',' + field(series.name) + ',' + number(p.x()) + ',' + number(p.y()) + '\n';
      }
    }
  }
  return csv;
}

}  // namespace handwheel
