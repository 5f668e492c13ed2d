"""A server that shows crowds to browsers and to clients of Foxglove and rosbridge: docs/web.md."""
