// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handwheel::haply {

// The opening handshake of a WebSocket (RFC 6455, sections 1.3 and 4.1).

// Creates a handshake key: 16 random bytes in base64, new for each connection.
std::string handshakeKey();
// Returns the answer that a server must give to a key. It proves that the server supports the protocol, and has read
// this very request.
std::string acceptFor(std::string_view key);

// Returns the HTTP request that opens a WebSocket.
std::string upgradeRequest(std::string_view host, std::string_view key);
// Returns true if the head of a server's response accepts the upgrade. From "HTTP/1.1" up to the empty line; names of
// fields in any case.
bool isUpgradeAccepted(std::string_view head, std::string_view key);

}  // namespace handwheel::haply
