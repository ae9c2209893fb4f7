// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/DeviceMessages.h"

#include "text/ErrorText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(HapticSession)
};

}  // namespace

Message notOpenedMessage(const QString& name, const Error& error) {
  return {Message::Weight::Error,
          Text::tr("%1 could not be opened").arg(name),
          errorSentence(error),
          errorAdvice(error),
          {},
          {}};
}

Message lostMessage(const QString& name, DeviceStatus status) {
  const bool isGone = status == DeviceStatus::Absent;
  return {Message::Weight::Warning,
          isGone ? Text::tr("%1 is not there").arg(name) : Text::tr("%1 has failed").arg(name),
          isGone ? Text::tr("It was unplugged, or is without power.") : Text::tr("It does not answer as it should."),
          isGone ? Text::tr("Plug it in again: it is opened by itself.")
                 : Text::tr("Plug it in again, and choose it once more in the panel “Device”."),
          {},
          {}};
}

Message unusedPluginMessage(const PluginListing& plugin) {
  return {Message::Weight::Warning,
          Text::tr("A device plugin is not used"),
          errorSentence(*plugin.error),
          errorAdvice(*plugin.error),
          {},
          {}};
}

}  // namespace handwheel
