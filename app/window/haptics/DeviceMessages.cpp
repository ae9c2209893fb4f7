// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/DeviceMessages.h"

#include "text/ErrorText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct DeviceMessagesWords {
  Q_DECLARE_TR_FUNCTIONS(HapticSession)
};

}  // namespace

Message notOpenedMessage(const QString& name, const Error& error) {
  return {Message::Weight::Error,
          DeviceMessagesWords::tr("%1 could not be opened").arg(name),
          errorSentence(error),
          errorAdvice(error),
          {},
          {}};
}

Message lostMessage(const QString& name, DeviceStatus status) {
  const bool isGone = status == DeviceStatus::Absent;
  return {Message::Weight::Warning,
          isGone ? DeviceMessagesWords::tr("%1 is not connected").arg(name)
                 : DeviceMessagesWords::tr("%1 has failed").arg(name),
          isGone ? DeviceMessagesWords::tr("It does not answer any more.")
                 : DeviceMessagesWords::tr("It does not respond correctly."),
          isGone ? DeviceMessagesWords::tr(
                       "Plug it in and switch it on. If it is not opened automatically then, press “Open again”.")
                 : DeviceMessagesWords::tr("Unplug it and plug it in again. If it is not opened automatically then, "
                                           "press “Open again”."),
          DeviceMessagesWords::tr("Open again"),
          {}};
}

Message unusedPluginMessage(const PluginInfo& plugin) {
  return {Message::Weight::Warning,
          DeviceMessagesWords::tr("A device plugin could not be loaded"),
          errorSentence(*plugin.error),
          errorAdvice(*plugin.error),
          {},
          {}};
}

}  // namespace handwheel
