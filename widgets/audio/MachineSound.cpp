// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audio/MachineSound.h"

#include "audio/SoundPlayer.h"

#include <QThread>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kLongestEndMs = 2000;  // for a device that is being opened

}  // namespace

MachineSound::MachineSound(QObject* parent) : QObject(parent) {
  m_rest.setSingleShot(true);
  m_rest.setInterval(kHeldMs);
  connect(&m_rest, &QTimer::timeout, this, &MachineSound::stop);
}

// The player is destroyed before its owner. A device that hangs while it is opened keeps its thread, and the program
// ends.
MachineSound::~MachineSound() {
  if (!m_thread) return;
  m_thread->quit();
  if (m_thread->wait(kLongestEndMs)) delete m_thread;
}

void MachineSound::setOn(bool isOn) {
  m_isOn = isOn;
  if (!isOn) stop();
}

void MachineSound::setVolume(double volume) {
  m_volume = std::isfinite(volume) ? std::clamp(volume, 0.0, 1.0) : 0.0;
  if (m_rest.isActive())
    QMetaObject::invokeMethod(m_player, [player = m_player, v = m_volume] { player->setVolume(v); });
}

void MachineSound::setState(const MachineSoundState& state) {
  if (!m_isOn) return;
  if (!m_rest.isActive()) start();
  m_rest.start();
  QMetaObject::invokeMethod(m_player, [player = m_player, state] { player->setState(state); });
}

void MachineSound::start() {
  if (!m_thread) {
    m_thread = new QThread;
    m_thread->setObjectName(QStringLiteral("sound"));
    m_player = new SoundPlayer;
    m_player->moveToThread(m_thread);
    connect(m_player, &SoundPlayer::deviceChanged, this, &MachineSound::deviceChanged);
    connect(m_thread, &QThread::finished, m_player, &QObject::deleteLater);
    m_thread->start();
  }
  QMetaObject::invokeMethod(m_player, [player = m_player, volume = m_volume] { player->start(volume); });
}

void MachineSound::stop() {
  m_rest.stop();
  if (m_player) QMetaObject::invokeMethod(m_player, [player = m_player] { player->stop(); });
}

}  // namespace handwheel
