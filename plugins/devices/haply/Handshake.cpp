// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Handshake.h"

#include <QCryptographicHash>
#include <QList>
#include <QRandomGenerator>
#include <array>

namespace handwheel::haply {

namespace {

constexpr std::string_view kProtocol = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // RFC 6455, section 1.3

// Returns the value of a field, without the blanks around it; empty if it is missing.
QByteArray fieldOf(const QByteArray& head, const QByteArray& name) {
  for (const QByteArray& line : head.split('\n')) {
    const qsizetype colon = line.indexOf(':');
    if (colon > 0 && line.left(colon).compare(name, Qt::CaseInsensitive) == 0) return line.mid(colon + 1).trimmed();
  }
  return {};
}

bool hasToken(const QByteArray& list, const QByteArray& token) {
  for (const QByteArray& each : list.split(','))
    if (each.trimmed().compare(token, Qt::CaseInsensitive) == 0) return true;
  return false;
}

}  // namespace

std::string handshakeKey() {
  std::array<quint32, 4> random{};
  QRandomGenerator::system()->fillRange(random.data(), random.size());
  return QByteArray(reinterpret_cast<const char*>(random.data()), sizeof(random)).toBase64().toStdString();
}

std::string acceptFor(std::string_view key) {
  const QByteArray both = QByteArray(key.data(), static_cast<qsizetype>(key.size())) +
                          QByteArray(kProtocol.data(), static_cast<qsizetype>(kProtocol.size()));
  return QCryptographicHash::hash(both, QCryptographicHash::Sha1).toBase64().toStdString();
}

std::string upgradeRequest(std::string_view host, std::string_view key) {
  return "GET / HTTP/1.1\r\nHost: " + std::string(host) +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " + std::string(key) +
         "\r\nSec-WebSocket-Version: 13\r\n\r\n";
}

bool isUpgradeAccepted(std::string_view head, std::string_view key) {
  const QByteArray lines(head.data(), static_cast<qsizetype>(head.size()));
  return head.starts_with("HTTP/1.1 101") && hasToken(fieldOf(lines, "Upgrade"), "websocket") &&
         hasToken(fieldOf(lines, "Connection"), "upgrade") &&
         fieldOf(lines, "Sec-WebSocket-Accept").toStdString() == acceptFor(key);
}

}  // namespace handwheel::haply
