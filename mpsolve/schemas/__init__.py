"""JSON Schemas of everything that is read and written, by name; each says its version in the key `version`."""
