// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "plot/Plot.h"
#include "theme/Theme.h"

#include <QImage>
#include <QSize>
#include <span>

namespace handwheel {

// Renders plots in a grid that is as nearly square as possible. May be called on any thread. A QGuiApplication must
// exist, because fonts are needed (on the platform "offscreen" if there is no display). size: the size of each plot, in
// pixels before scaling by pixelRatio.
QImage plotImage(std::span<const Plot> plots, const QSize& size, ThemeKind theme, double pixelRatio = 1.0);

// Writes plots to a picture or a table, according to the extension of the path. Pictures are .png and .svg files,
// tables are .csv files. Writes the whole file or nothing. Errors: ExtensionUnknown {extension}, WriteFailed {system's
// reason}.
Status exportPlots(std::span<const Plot> plots, const QString& path, const QSize& size, ThemeKind theme);

// Converts plots to CSV, with one line for each point. The columns are plot, series, x, y, with a header line; numbers
// are in the shortest form, with a decimal point.
QByteArray plotCsv(std::span<const Plot> plots);

}  // namespace handwheel
