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

// Plots beside and below each other, as nearly square as they are many. Any thread; needs fonts, so a QGuiApplication
// (on the platform "offscreen" where there is no display). size: of each plot, in pixels before the ratio.
QImage plotImage(std::span<const Plot> plots, const QSize& size, ThemeKind theme, double pixelRatio = 1.0);

// Writes plots by the ending of the path: a picture (.png, .svg), or the numbers (.csv). The whole file or nothing.
// Errors: ExtensionUnknown {extension}, WriteFailed {system's reason}.
Status exportPlots(std::span<const Plot> plots, const QString& path, const QSize& size, ThemeKind theme);

// One line for each point: plot, series, x, y, with a header line; numbers in the shortest form, with a decimal point.
QByteArray plotCsv(std::span<const Plot> plots);

}  // namespace handwheel
