return require "parts.circle_b"
