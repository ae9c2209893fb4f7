// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/LatheReadout.h"

#include "machining/force/WorkMaterials.h"
#include "theme/Theme.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

QString figure(double value, int digits) {
  return QLocale().toString(value, 'f', digits);
}

QString nameOf(ForceLaw law) {
  switch (law) {
    case ForceLaw::Kosilova:
      return QCoreApplication::translate("LatheReadout", "Kosilova");
    case ForceLaw::Kienzle:
      return QCoreApplication::translate("LatheReadout", "Kienzle");
    case ForceLaw::Network:
      break;
  }
  return QCoreApplication::translate("LatheReadout", "Network");
}

void setWarning(QLabel& label, bool isWarning) {
  QPalette palette = label.parentWidget()->palette();
  if (isWarning) palette.setColor(QPalette::WindowText, themeColours(currentTheme()).error);
  label.setPalette(palette);
}

}  // namespace

LatheReadout::LatheReadout(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("latheFigures"));
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(12);
  m_force = cell(*line, tr("Resultant force"), "latheForce", tr("%1 of %2 %3").arg(8888).arg(8888).arg(tr("N")),
                 tr("Resultant of cutting, feed and radial force, and the limit of the exercise"));
  m_power = cell(*line, tr("Motor power"), "lathePower", tr("%1 of %2 %3").arg(8.88).arg(88).arg(tr("kW")),
                 tr("Power taken from the motor, and its rated power"));
  m_torque = cell(*line, tr("Torque"), "latheTorque", tr("%1 of %2 %3").arg(88.8).arg(888).arg(tr("N·m")),
                  tr("Torque at the spindle, and the torque available"));
  m_spindle = cell(*line, tr("Spindle"), "latheTurns", tr("%1 r/min").arg(8888),
                   tr("Current spindle speed. A cut beyond the available power or torque slows it down."));
  m_speed = cell(*line, tr("Cutting speed"), "latheCuttingSpeed", tr("%1 m/min").arg(8888),
                 tr("Surface speed at the middle of the cut"));
  m_depth = cell(*line, tr("Depth"), "latheDepth", tr("%1 mm").arg(88.88),
                 tr("Depth of cut, measured across the feed direction"));
  m_feed =
      cell(*line, tr("Feed"), "latheFeedNow", tr("%1 mm/rev").arg(8.888), tr("Feed per revolution of the spindle"));
  m_roughness = cell(
      *line, tr("Ra here"), "latheRoughness", tr("%1 µm").arg(88.88),
      tr("Roughness of the part at the tool, from feed and nose radius and from later work with file, paper or disk"));
  m_law = cell(*line, tr("Law"), "latheLaw", tr("Kosilova"), QString());
  line->addStretch();
}

// Each as wide as its widest text, so that nothing jumps while figures change.
QLabel* LatheReadout::cell(QHBoxLayout& line, const QString& name, const char* id, const QString& widest,
                           const QString& tip) {
  auto* const column = new QVBoxLayout;
  column->setSpacing(0);
  auto* const title = new QLabel(name);
  title->setProperty("muted", true);
  auto* const value = new QLabel;
  value->setObjectName(QString::fromLatin1(id));
  value->setAccessibleName(name);
  for (QWidget* each : {title, value}) each->setToolTip(tip);
  value->setMinimumWidth(fontMetrics().horizontalAdvance(widest));
  column->addWidget(title);
  column->addWidget(value);
  line.addLayout(column);
  return value;
}

void LatheReadout::showLimited(QLabel& label, double value, double limit, int digits, const QString& unit) {
  label.setText(
      limit > 0.0
          ? tr("%1 of %2 %3").arg(figure(value, digits), figure(limit, limit == std::floor(limit) ? 0 : digits), unit)
          : QStringLiteral("%1 %2").arg(figure(value, digits), unit));
  setWarning(label, limit > 0.0 && value > limit);
}

void LatheReadout::show(const ManualLatheTool& tool) {
  const auto now = tool.moment();
  const LatheLoad& load = now->load;
  const LatheSpindle spindle = tool.setup().spindle;
  const WorkLimits& limits = tool.limits();
  const double power =
      limits.power > 0.0 && (spindle.power == 0.0 || limits.power < spindle.power) ? limits.power : spindle.power;
  // The marks count the power that the set speed asks for.
  showLimited(*m_force, load.forces.norm(), limits.force, 0, tr("N"));
  showLimited(*m_power, load.power, power, 2, tr("kW"));
  if (load.isOverloaded) setWarning(*m_power, true);
  showLimited(*m_torque, load.torque, spindle.torque, 1, tr("N·m"));
  const QString none = QStringLiteral("–");
  m_spindle->setText(tr("%1 r/min").arg(figure(now->machine.speed, 0)));
  setWarning(*m_spindle, load.isOverloaded);
  m_speed->setText(load.isCutting ? tr("%1 m/min").arg(figure(load.cut.speed, 0)) : none);
  m_depth->setText(load.isCutting ? tr("%1 mm").arg(figure(load.cut.depth, 2)) : none);
  m_feed->setText(load.isCutting ? tr("%1 mm/rev").arg(figure(load.cut.feed, 3)) : none);
  const bool isThread = now->machine.lead != 0.0;
  setWarning(*m_feed, load.isCutting && !isThread && limits.feed > 0.0 && load.cut.feed > limits.feed);
  const std::optional<double> rough = tool.roughnessHere();
  m_roughness->setText(rough && std::isfinite(*rough) ? tr("%1 µm").arg(figure(*rough, 2)) : none);
  showLaw(tool, *now);
}

// The law that gives the force, which may be another one than was chosen; the tool tip says why.
void LatheReadout::showLaw(const ManualLatheTool& tool, const LatheMoment& now) {
  const LatheMaterial& material = *tool.material();
  const auto index = std::find(tool.tools().begin(), tool.tools().end(), now.tool) - tool.tools().begin();
  const CuttingForceModel* const model = material.lawOf(static_cast<std::size_t>(index));
  setWarning(*m_law, model && now.load.isOutsideModel);
  if (!model) {
    m_law->setText(QStringLiteral("–"));
    return m_law->setToolTip(QString());
  }
  const WorkMaterial& known = WorkMaterials::standard().called(material.id);
  const QString name = QCoreApplication::translate("Property", known.name.c_str());
  const LawInUse used = lawInUse(*model, known);
  QStringList tip{tr("Law of the cutting force for %1. It is chosen among the settings of speed and accuracy; the "
                     "material is a property of the workpiece.")
                      .arg(name)};
  QString text = nameOf(used.law);
  if (used.law != material.law)
    tip += tr("%1 has no data for this material, so Kienzle is used.").arg(nameOf(material.law));
  if (!used.isVerified) {
    text = tr("%1, unverified").arg(text);
    tip += tr("Not all numbers of its table were compared with the handbook.");
  }
  if (now.load.isOutsideModel && used.law == ForceLaw::Network) {
    text = tr("Power law");
    tip += tr("The cut is outside the range of the network, so the power law fitted to the same data is used.");
  } else if (now.load.isOutsideModel) {
    text = tr("%1, outside its range").arg(text);
    tip += tr("The law of the cutting force is not valid for such a cut of %1.").arg(name);
  }
  m_law->setText(text);
  m_law->setToolTip(tip.join(QLatin1Char('\n')));
}

}  // namespace handwheel
