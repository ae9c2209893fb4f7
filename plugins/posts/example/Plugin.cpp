// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "example/ExamplePost.h"
#include "robot/posts/PostPlugin.h"

#include <QObject>

Q_DECLARE_INTERFACE(handwheel::PostPlugin, HANDWHEEL_POST_PLUGIN)

class ExamplePostPlugin : public QObject, public handwheel::PostPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID HANDWHEEL_POST_PLUGIN FILE "example.json")
  Q_INTERFACES(handwheel::PostPlugin)

 public:
  std::unique_ptr<handwheel::PostProcessor> post() override { return std::make_unique<handwheel::ExamplePost>(); }
};

#include "Plugin.moc"
