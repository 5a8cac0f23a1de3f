"""Controls of appliances and lamps: buttons, dials, panels."""
