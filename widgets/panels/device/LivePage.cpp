// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/LivePage.h"

#include "haptics/servo/ServoSample.h"
#include "panels/device/AxisBars.h"
#include "panels/device/ButtonLamps.h"
#include "panels/device/ForcePlot.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

namespace handwheel {

namespace {
constexpr int kPlotHeight = 232;       // logical pixels
constexpr double kBetweenAxes = 0.05;  // s: no eye reads numbers that change faster
}  // namespace

LivePage::LivePage(QWidget* parent)
    : QWidget(parent),
      m_axes(new AxisBars(this)),
      m_buttons(new ButtonLamps(this)),
      m_forceOn(new QCheckBox(tr("Force on"), this)),
      m_forceTest(new QPushButton(tr("Test the force"), this)),
      m_noForce(new QLabel(tr("This device has no motors: the force is only shown."), this)),
      m_torque(new QLabel(this)),
      m_plot(new ForcePlot(this)) {
  m_axes->setObjectName(QStringLiteral("axisBars"));
  m_buttons->setObjectName(QStringLiteral("buttonLamps"));
  m_forceOn->setObjectName(QStringLiteral("forceOn"));
  m_forceOn->setToolTip(tr("Let the device apply forces; without this it only points"));
  m_forceTest->setObjectName(QStringLiteral("forceTest"));
  m_forceTest->setToolTip(tr("The device pushes gently along each axis. Hold the grip."));
  m_noForce->setObjectName(QStringLiteral("noForce"));
  m_noForce->setProperty("muted", true);
  m_noForce->setWordWrap(true);
  m_noForce->hide();
  m_torque->setObjectName(QStringLiteral("deviceTorque"));
  m_torque->setToolTip(tr("Torque that is sent to the device, of the largest that it has"));
  m_torque->hide();
  m_plot->setObjectName(QStringLiteral("forcePlot"));
  m_plot->setMinimumHeight(kPlotHeight);
  auto* force = new QHBoxLayout;
  force->setSpacing(8);
  force->addWidget(m_forceOn);
  force->addStretch();
  force->addWidget(m_forceTest);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 12);
  column->setSpacing(8);
  column->addWidget(m_axes);
  column->addWidget(m_buttons);
  column->addLayout(force);
  column->addWidget(m_noForce);
  column->addWidget(m_torque);
  column->addWidget(m_plot, 1);
  connect(m_forceOn, &QCheckBox::clicked, this, &LivePage::forceOnChanged);
  connect(m_axes, &AxisBars::handLed, this, [this](const HandPose& hand) {
    m_hand = hand;
    emit handLed(hand);
  });
  connect(m_buttons, &ButtonLamps::toggled, this, [this](int button) {
    m_hand.buttons ^= 1u << button;
    m_axes->showHand(m_hand);
    emit handLed(m_hand);
  });
  connect(m_forceTest, &QPushButton::clicked, this, &LivePage::forceTestRequested);
  showDevice({});
}

void LivePage::showDevice(const DeviceInUse& view) {
  m_view = view;
  const bool hasMotors = view.capabilities.outputs > 0;
  m_axes->setDevice(view.capabilities);
  m_axes->setLed(view.isLed);
  m_buttons->setCount(view.chosen ? view.capabilities.buttons : 0);
  m_buttons->setLed(view.isLed);
  m_forceOn->setChecked(view.isForceOn);
  m_noForce->setVisible(view.chosen && !hasMotors);
  m_torque->setVisible(view.chosen && view.capabilities.maxTorque > 0.0);
  showTorque(0.0);
  for (QWidget* part : {static_cast<QWidget*>(m_forceOn), static_cast<QWidget*>(m_forceTest)}) {
    part->setVisible(!view.chosen || hasMotors);
  }
  enableForce(view.status);
}

void LivePage::enableForce(DeviceStatus status) {
  m_forceOn->setEnabled(m_view.chosen.has_value());
  m_forceTest->setEnabled(m_view.chosen && m_view.isForceOn && status == DeviceStatus::Ready);
}

void LivePage::showSample(const ServoSample& sample, double forceGain) {
  if (std::abs(sample.tip.time - m_shown) >= kBetweenAxes) {
    m_shown = sample.tip.time;
    m_axes->showState(sample.device);
    showTorque(sample.sent.torque.norm());
  }
  m_buttons->showButtons(sample.device.buttons);
  m_plot->showSample(sample, forceGain);
  enableForce(sample.device.status);
}

void LivePage::showTorque(double torque) {
  m_torque->setText(
      tr("Torque: %1 of %2 N·mm")
          .arg(locale().toString(torque, 'f', 0), locale().toString(m_view.capabilities.maxTorque, 'f', 0)));
}

void LivePage::showHand(const HandPose& hand) {
  m_hand = hand;
  m_axes->showHand(hand);
}

void LivePage::setAxisWords(const QStringList& words) {
  m_axes->setWords(words);
}

void LivePage::clear() {
  m_axes->showState({});
  m_buttons->showButtons(0);
  m_plot->clear();
  showTorque(0.0);
}

}  // namespace handwheel
