"""Equal vehicles in an endless row, and what it says of finite trains."""
