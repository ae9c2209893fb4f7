// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/TickTiming.h"

#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSession.h"

#include <QLocale>

namespace handwheel {

namespace {

constexpr std::size_t kKeptSamples = 120;  // two seconds of samples
constexpr int kEvery = 30;                 // samples: half a second
constexpr std::size_t kEnough = 30;

}  // namespace

TickTiming::TickTiming(HapticSession& session, FidelityChoice& choice, QWidget* parent)
    : QLabel(parent), m_session(session), m_choice(choice) {
  setObjectName(QStringLiteral("tickUse"));
  setWordWrap(true);
  hide();
  connect(&session, &HapticSession::sampled, this, &TickTiming::sample);
  connect(&session, &HapticSession::chosenChanged, this, [this] {
    m_ticks.clear();
    m_sinceUpdate = 0;
    if (!m_session.isOpen()) hide();
  });
}

void TickTiming::sample() {
  const ServoSample* const last = m_session.latest();
  // None: closed by who heard of the sample before. And what nobody sees is not worked out.
  if (!last || !parentWidget()->isVisible()) return;
  m_ticks.push_back({static_cast<double>(last->microseconds), last->felt.isContact});
  if (m_ticks.size() > kKeptSamples) m_ticks.pop_front();
  if (++m_sinceUpdate < kEvery) return;
  m_sinceUpdate = 0;
  setText(text());
  show();
}

QString TickTiming::text() const {
  const ServoStatistics* const measure = m_session.measure();
  std::vector<double> all, touching;
  for (const Tick& tick : m_ticks) {
    all.push_back(tick.microseconds);
    if (tick.isContact) touching.push_back(tick.microseconds);
  }
  const double period = 1e6 * measure->nominalPeriod(), usual = median(all);
  const QString use = tr("Servo tick in use: %1 of %2 µs (%3 %)")
                          .arg(locale().toString(usual, 'f', 1), locale().toString(period, 'f', 0),
                               locale().toString(100.0 * usual / period, 'f', 1));
  const std::optional<double> predicted = m_choice.predictedTick(1.0 / measure->nominalPeriod());
  if (!predicted) return use;
  const QString expected = locale().toString(*predicted, 'f', 1);
  if (touching.size() < kEnough) return use + QLatin1Char('\n') + tr("Predicted while touching: %1 µs").arg(expected);
  const double touch = median(touching);
  return use + QLatin1Char('\n') +
         tr("While touching: %1 µs, predicted %2 µs (%3 %)")
             .arg(locale().toString(touch, 'f', 1), expected,
                  QString(touch < *predicted ? QString() : QStringLiteral("+")) +
                      locale().toString(100.0 * (touch / *predicted - 1.0), 'f', 0));
}

}  // namespace handwheel
