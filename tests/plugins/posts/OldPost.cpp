// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QObject>
#include <cstdlib>

// Made for another version of the interface. Any of its code that runs ends the test.
class OldPost : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "handwheel.post/0")

 public:
  OldPost() { std::abort(); }
};

static const int kLoaded = (std::abort(), 0);

#include "OldPost.moc"
