// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/ForcePlot.h"

#include "haptics/servo/ServoSample.h"

#include <cmath>

namespace handwheel {

namespace {
constexpr double kBetweenPictures = 0.1;  // s: each picture costs a software renderer that of the whole window
constexpr double kSmallestScale = 1.0;    // N: less would show noise as if it were a force
}  // namespace

ForcePlot::ForcePlot(QWidget* parent) : PlotWidget(parent) {
  draw();
}

void ForcePlot::showSample(const ServoSample& sample, double forceGain) {
  m_trace.add({sample.tip.time, forceGain * sample.felt.force.norm(), sample.sent.force.norm()});
  if (m_trace.size() == 0 || !isVisible() || !reading().isEmpty()) return;
  if (std::abs(m_trace.last().time - m_drawn) < kBetweenPictures) return;
  if (!m_isStill || !m_trace.isStill()) draw();
}

void ForcePlot::clear() {
  m_trace.clear();
  draw();
}

void ForcePlot::showEvent(QShowEvent* event) {
  draw();
  PlotWidget::showEvent(event);
}

void ForcePlot::draw() {
  m_drawn = m_trace.size() > 0 ? m_trace.last().time : 0.0;
  m_isStill = m_trace.isStill();
  Plot plot;
  plot.title = tr("Force of the last seconds");
  plot.x = {tr("Time"), QStringLiteral("s"), false, {-ForceTrace::kSeconds, 0.0}};
  plot.y = {tr("Force"), QStringLiteral("N"), false, {0.0, kSmallestScale}};
  plot.locale = locale();
  PlotSeries asked, sent;
  asked.name = tr("asked for");
  sent.name = tr("sent");
  asked.dotted = sent.dotted = false;
  for (std::size_t i = 0; i < m_trace.size(); ++i) {
    const ForceTrace::Point& point = m_trace.at(i);
    asked.points.emplace_back(point.time - m_drawn, point.asked);
    sent.points.emplace_back(point.time - m_drawn, point.sent);
  }
  plot.series = {std::move(asked), std::move(sent)};
  setPlot(std::move(plot));
}

}  // namespace handwheel
