// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QObject>
#include <cstdlib>

// A plugin for another version of the interface. Any of its code that runs ends the test.
class OldPlugin : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "handwheel.device/0" FILE "old.json")

 public:
  OldPlugin() { std::abort(); }
};

static const int kLoaded = (std::abort(), 0);

#include "OldPlugin.moc"
