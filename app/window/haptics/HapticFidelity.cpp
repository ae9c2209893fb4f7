// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/HapticFidelity.h"

#include "haptics/scene/TouchFidelity.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

HapticFidelity::HapticFidelity(FidelityChoice& choice, HapticSession& session, HapticSceneBuilder& touch,
                               QObject* parent)
    : QObject(parent), m_choice(choice), m_session(session), m_touch(touch) {
  connect(&choice, &FidelityChoice::changed, this, &HapticFidelity::follow);
  connect(&session, &HapticSession::touchChanged, this, [this] {
    const FidelitySetting setting = contactStiffnessSetting();
    const double asked = m_session.touch().stiffness;
    if (asked != m_choice.values().of(setting)) m_choice.set(setting.id, asked);
  });
  follow();
}

void HapticFidelity::follow() {
  const FidelityValues& values = m_choice.values();
  m_session.setServo(servoSettings(values));
  m_touch.setFidelity(values);
  TouchSettings touch = m_session.touch();
  touch.stiffness = values.of(contactStiffnessSetting());
  m_session.setTouch(touch);
}

}  // namespace handwheel
