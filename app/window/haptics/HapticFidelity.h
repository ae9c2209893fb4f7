// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace handwheel {

class FidelityChoice;
class HapticSession;
class HapticSceneBuilder;

// Applies the chosen accuracy settings to the haptic device. They are the rate and velocity window of its loop, and the
// stiffness and tolerance of the contact. The stiffness in the device panel and the accuracy setting follow each other.
// Must be used on the window thread.
class HapticFidelity : public QObject {
  Q_OBJECT

 public:
  HapticFidelity(FidelityChoice& choice, HapticSession& session, HapticSceneBuilder& touch, QObject* parent = nullptr);

 private:
  void follow();

  FidelityChoice& m_choice;
  HapticSession& m_session;
  HapticSceneBuilder& m_touch;
};

}  // namespace handwheel
