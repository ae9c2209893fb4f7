// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/LatheWheels.h"

#include "controls/machine/HandwheelDial.h"

#include <QGridLayout>
#include <QLabel>
#include <utility>

namespace handwheel {

namespace {

// The direction of a slide along its axis for a wheel turned clockwise, by LatheAxis. So it is in the manuals of engine
// lathes: OTMT SC4, page 9 (carriage), Grizzly G4002, page 22 (cross slide).
constexpr std::array<double, kLatheAxes> kClockwise{1.0, -1.0, -1.0, 1.0};
constexpr QChar kTravel(u'Δ');

}  // namespace

LatheWheels::LatheWheels(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  struct Wheel {
    const char* id;
    QString name;
    QString direction;
  };
  const std::array<Wheel, kLatheAxes> wheels{
      {{"latheCarriage", tr("Carriage"), tr("Clockwise: away from the chuck. In the view: ← and →")},
       {"latheCross", tr("Cross slide"),
        tr("Clockwise: in, to the axis; counts as the read-out does, on the diameter (⌀) or the radius (R). In the "
           "view: ↑ "
           "and ↓")},
       {"latheCompound", tr("Compound slide"), tr("Clockwise: forward. In the view: Page Up and Page Down")},
       {"latheQuill", tr("Tailstock quill"), tr("Clockwise: out, to the work")}}};
  for (std::size_t i = 0; i < kLatheAxes; ++i) {
    auto* const dial = m_dials[i] = new HandwheelDial;
    dial->setObjectName(QString::fromLatin1(wheels[i].id));
    dial->setLabel(wheels[i].name);
    dial->setMouseFirst();
    dial->setPrefix(kTravel);
    dial->setToolTip(tr("Δ: travel since the ring was at zero; it is not a size of the part") + QLatin1Char('\n') +
                     wheels[i].direction + QLatin1Char('\n') + dial->toolTip());
    auto* const caption = m_captions[i] = new QLabel(wheels[i].name);
    caption->setAlignment(Qt::AlignHCenter);
    grid->addWidget(dial, 0, static_cast<int>(i));
    grid->addWidget(caption, 1, static_cast<int>(i));
    connect(dial, &HandwheelDial::moved, this, [this, i](double shown) {
      const double mm = shown / m_scales[i];
      const double by = mm - std::exchange(m_turned[i], mm);
      emit turned(static_cast<LatheAxis>(i), kClockwise[i] * by);
    });
  }
}

// On the diameter a dial counts twice the travel of its slide; its ring stays.
void LatheWheels::countOnDiameter(bool isDiameter) {
  constexpr auto kCross = static_cast<std::size_t>(LatheAxis::Cross);
  const double before = std::exchange(m_scales[kCross], isDiameter ? 2.0 : 1.0);
  HandwheelDial& dial = *m_dials[kCross];
  dial.setPrefix(kTravel + (isDiameter ? QStringLiteral("⌀") : QStringLiteral("R")));
  if (before != m_scales[kCross]) dial.setZero(dial.zero() * m_scales[kCross] / before);
}

// Includes rotation that the slides have not followed yet.
void LatheWheels::show(const ManualLatheTool& tool) {
  const LatheSetup setup = tool.setup();
  const auto now = tool.moment();
  countOnDiameter(setup.showsDiameter);
  for (std::size_t i = 0; i < kLatheAxes; ++i) {
    m_turned[i] = kClockwise[i] * (now->machine.wheels[i] + now->machine.demands[i]);
    m_dials[i]->setDivisions(setup.dials[i].divisions, m_scales[i] * setup.dials[i].perDivision);
    m_dials[i]->setValue(m_scales[i] * m_turned[i]);
  }
  constexpr auto kQuill = static_cast<std::size_t>(LatheAxis::Quill);
  m_dials[kQuill]->setVisible(setup.tailstock.isUsed());
  m_captions[kQuill]->setVisible(setup.tailstock.isUsed());
}

LatheWheels::Rings LatheWheels::rings() const {
  Rings rings{};
  for (std::size_t i = 0; i < kLatheAxes; ++i) rings[i] = m_dials[i]->zero() / m_scales[i];
  return rings;
}

void LatheWheels::setRings(const ManualLatheTool& tool, const std::optional<Rings>& rings) {
  show(tool);
  const Rings set = rings.value_or(m_turned);
  for (std::size_t i = 0; i < kLatheAxes; ++i) m_dials[i]->setZero(m_scales[i] * set[i]);
}

}  // namespace handwheel
