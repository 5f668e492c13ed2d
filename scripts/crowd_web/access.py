"""Who may use the server: by the names of hosts in a request, and by a token."""
import hmac
import ipaddress
import secrets
import urllib.parse

from aiohttp import web

COOKIE = 'social_crowd_token'


def make_token():
    """Returns a random token."""
    return secrets.token_urlsafe(24)


def is_loopback(host):
    """Returns whether a name or an address is that of this machine only."""
    try:
        return ipaddress.ip_address(host.strip('[]')).is_loopback
    except ValueError:
        return host.lower() == 'localhost'


def name_of(netloc):
    """Returns the host of HOST:PORT, '' for anything else."""
    try:
        return urllib.parse.urlsplit('//' + netloc).hostname or ''
    except ValueError:
        return ''


class Access:
    """Refuses requests of pages of other sites, those to other names than this machine's unless there is a token, and
    those without it if there is one."""

    def __init__(self, token=None, origins=()):
        self.token = token
        self.origins = frozenset(origins)  # further ones that may connect

    def refuse(self, request):
        """Returns why a request is refused, or None."""
        origin = request.headers.get('Origin')
        if origin is not None and origin not in self.origins and origin not in (
                f'http://{request.host}', f'https://{request.host}'):
            return f'the origin {origin[:100]} may not connect; --allow-origin allows it'
        if self.token is None:
            # A name that resolves to this machine may be one of another site.
            return None if is_loopback(name_of(request.host)) else 'expected a host name of this machine'
        given = request.query.get('token', request.cookies.get(COOKIE, ''))
        if not hmac.compare_digest(given.encode('utf-8', 'surrogateescape'), self.token.encode()):
            return 'expected the token that the server has printed, as in /?token=TOKEN'
        return None

    @web.middleware
    async def check(self, request, handler):
        """Answers refused requests; lets a browser that has the token keep it for the other files of the page."""
        problem = self.refuse(request)
        if problem:
            raise web.HTTPForbidden(text=problem + '\n')
        response = await handler(request)
        if not response.prepared:
            response.headers.update({
                'X-Content-Type-Options': 'nosniff', 'Referrer-Policy': 'no-referrer', 'Cache-Control': 'no-cache',
                'Content-Security-Policy': "frame-ancestors 'none'; object-src 'none'; base-uri 'none'"})
            if self.token is not None:
                response.set_cookie(COOKIE, self.token, httponly=True, samesite='Strict')
        return response
