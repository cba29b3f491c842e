// Includes nothing: its exception is not needed.
